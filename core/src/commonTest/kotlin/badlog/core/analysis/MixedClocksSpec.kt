package badlog.core.analysis

import badlog.core.bag.BagParser
import badlog.core.recording.CellCounts
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

private fun withOwnTimes(text: String, times: DoubleArray): LogView {
    val recording = BagParser().apply { accept(text.encodeToByteArray()) }.finish()
    val counts = CellCounts(times.size, 0, 0, 0, 0, 0)
    val calculated = Topic("calculated", "V", emptyList(), DoubleArray(times.size) { it + 0.5 }, TextColumn.EMPTY, counts, times)
    return LogView.of(recording.copy(topics = recording.topics + calculated))
}

private fun LogView.points(name: String) = seriesOf(recording.topics.single { it.name == name }).data.run { x.toList().zip(y.toList()) }

class MixedClocksSpec : FunSpec({
    val bag = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"a","unit":"V"}],"values":[]}""" +
        "\nTime,a\n1,10\n2,20\n"

    test("a topic with times of its own does not replace the rows' x axis") {
        val view = withOwnTimes(bag, doubleArrayOf(0.25, 7.5))
        view.xAxis.topic?.name shouldBe "Time"
        view.points("a") shouldBe listOf(1.0 to 10.0, 2.0 to 20.0)
        view.points("calculated") shouldBe listOf(0.25 to 0.5, 7.5 to 1.5)
        view.problems.shouldBeEmpty()
    }

    test("x includes the rows and topics' own times, each as a clock") {
        val view = withOwnTimes(bag, doubleArrayOf(0.25, 7.5))
        view.xAxis.range shouldBe 0.25..7.5
        view.xAxis.clocks.map { it.toList() } shouldBe listOf(listOf(1.0, 2.0), listOf(0.25, 7.5))
    }

    test("a moved line still knows where its recording has samples") {
        val view = withOwnTimes(bag, doubleArrayOf(0.25, 7.5))
        val line = view.seriesOf(view.recording.topics.single { it.name == "a" })
        line.recorded shouldBe 0.25..7.5
        line.moved(2.0, " (other)").recorded shouldBe 2.25..9.5
        LogView.of(BagParser().finish()).run { recording.topics.map { seriesOf(it).recorded } }.filterNotNull().shouldBeEmpty()
    }

    test("topics with the same times share one clock, even if others are between them") {
        val view = withOwnTimes(bag, doubleArrayOf(0.25, 7.5))
        val one = view.recording.topics.last()
        val other = Topic("other", "V", emptyList(), one.samples, one.texts, one.counts, doubleArrayOf(0.25, 7.5))
        val again = Topic("again", "V", emptyList(), one.samples, one.texts, one.counts, one.times)
        val both = view.recording.run { LogView.of(copy(topics = topics + other + again)) }
        both.xAxis.clocks.size shouldBe 3
    }

    test("rows without an x axis are still counted") {
        val view = withOwnTimes("a,b\n10,1\n20,2\n", doubleArrayOf(0.5))
        view.xAxis.isIndex shouldBe true
        view.points("a") shouldBe listOf(0.0 to 10.0, 1.0 to 20.0)
    }
})
