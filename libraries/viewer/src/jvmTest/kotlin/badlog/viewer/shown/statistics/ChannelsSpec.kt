package badlog.viewer.shown.statistics

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.bag.BagParser
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.signalTopicsOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class ChannelsSpec : FunSpec({
    fun channelsOf(vararg names: String, unit: String = "A", values: (second: Int) -> List<Double>): Channels {
        val topics = listOf("""{"name":"Time","unit":"s","attrs":["xaxis"]}""") + names.map { """{"name":"$it","unit":"$unit","attrs":[]}""" }
        val rows = (0..100).joinToString("\n") { (listOf("$it") + values(it)).joinToString(",") }
        val text = """{"topics":$topics,"values":[]}""" + "\nTime,${names.joinToString(",")}\n$rows\n"
        val view = LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish())
        return Channels.of(view, signalTopicsOf(view, RuleSet.BUILT_IN.signals))
    }

    val all = listOf(Span(0.0, 100.0))

    test("channels are ranked by charge or by their highest current, with their share") {
        val channels = channelsOf("PDP/Current 0", "PDP/Current 1", "PDP/Current 2") { listOf(36.0, if (it == 50) 90.0 else 0.0, 0.0) }
        val byCharge = channels.ranked(all, ChannelOrder.CHARGE)
        byCharge.map { it.name } shouldContainExactly listOf("Current 0", "Current 1")
        byCharge.map { it.chargeText } shouldContainExactly listOf("1 Ah", "0.025 Ah")
        byCharge.map { it.shareText } shouldContainExactly listOf("97.6 %", "2.4 %")
        channels.ranked(all, ChannelOrder.PEAK).map { it.name to it.peakText } shouldContainExactly
            listOf("Current 1" to "90 A", "Current 0" to "36 A")
    }

    test("only the parts of x count") {
        val channels = channelsOf("PDP/Current 0", "PDP/Current 1") { if (it < 50) listOf(10.0, 0.0) else listOf(0.0, 20.0) }
        channels.ranked(listOf(Span(60.0, 70.0)), ChannelOrder.CHARGE).map { it.name } shouldContainExactly listOf("Current 1")
        channels.ranked(listOf(Span(0.0, 10.0), Span(60.0, 70.0)), ChannelOrder.CHARGE).map { it.name } shouldContainExactly
            listOf("Current 1", "Current 0")
    }

    test("currents in other units are amperes, and without channels motors are shown") {
        channelsOf("PDP/Current 0", unit = "mA") { listOf(5000.0) }.ranked(all, ChannelOrder.PEAK).single().peakText shouldBe "5 A"
        channelsOf("Arm/Supply Current") { listOf(5.0) }.ranked(all, ChannelOrder.PEAK).single().topic shouldBe "Arm/Supply Current"
        channelsOf("Arm/Angle", unit = "deg") { listOf(5.0) }.ranked(all, ChannelOrder.PEAK).shouldBeEmpty()
    }
})
