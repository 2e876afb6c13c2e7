package badlog.signals.battery

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.json.quotedJson
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.withSignals
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.sin

class BatteryUseSpec : FunSpec({
    fun logOf(
        seconds: IntRange = 0..200,
        enabled: IntRange = 20..170,
        values: Map<String, String> = emptyMap(),
        unit: String = "s",
        texts: Pair<String, List<String>>? = null,
        amps: (Double) -> String = { "${60 + 50 * sin(it)}" },
    ): BatteryUse? {
        val perSecond = if (unit == "ms") 1000 else 1
        val topics = listOf("Time", "Enabled", "Battery Voltage", "Total Current") + listOfNotNull(texts?.first)
        val described = topics.joinToString(",") { name ->
            val (own, attribute) = when (name) {
                "Time" -> unit to "\"xaxis\""
                "Battery Voltage" -> "V" to ""
                "Total Current" -> "A" to ""
                else -> "ul" to ""
            }
            """{"name":${quotedJson(name)},"unit":"$own","attrs":[$attribute]}"""
        }
        val given = values.entries.joinToString(",") { (name, value) -> """{"name":"$name","value":"$value"}""" }
        val rows = (seconds.first * 10..seconds.last * 10).map { tenth ->
            val time = tenth / 10.0
            val isEnabled = time >= enabled.first && time < enabled.last
            val amp = if (isEnabled) amps(time) else "2"
            val volts = (if (time < enabled.first) 12.8 else 12.3) - 0.02 * (amp.toDoubleOrNull() ?: 0.0)
            listOfNotNull("${time * perSecond}", "$isEnabled", "$volts", amp, texts?.second?.let { it[minOf(it.size - 1, tenth)] }).joinToString(",")
        }
        val text = (listOf("""{"topics":[$described],"values":[$given]}""", topics.joinToString(",")) + rows).joinToString("\n", postfix = "\n")
        val vocabulary = RuleSet.BUILT_IN.signals
        val view = LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish()).withSignals(vocabulary, "log")
        return batteryUseOf(view, vocabulary)
    }

    test("a robot browned out if its computer reports it while enabled; without a report, if the voltage was low enough then") {
        fun browned(flags: (Int) -> Boolean) = logOf(texts = "Browned Out" to List(2000) { "${flags(it)}" }, amps = { if (it in 90.0..90.5) "320" else "60" })?.isBrownedOut
        logOf()?.isBrownedOut shouldBe false
        logOf(amps = { if (it in 90.0..90.5) "320" else "60" })?.isBrownedOut shouldBe true
        browned { it in 1000..1002 } shouldBe true
        browned { it > 1800 } shouldBe false
    }

    for (unit in listOf("s", "ms")) {
        test("a log over $unit shows the voltage at rest, the energy and the resistance") {
            val use = logOf(unit = unit).shouldNotBeNull()
            use.topic shouldBe "Battery Voltage"
            use.restBefore.shouldNotBeNull() shouldBe (12.76 plusOrMinus 0.001)
            use.restAfter.shouldNotBeNull() shouldBe (12.26 plusOrMinus 0.001)
            use.resistance.shouldNotBeNull().milliohms shouldBe (20.0 plusOrMinus 0.1)
            // 150 s of 60 A on average at 11.1 V, less the oscillation's losses, and a little while disabled.
            use.energy.shouldNotBeNull() shouldBe (150 * (60 * 11.1 - 0.02 * 1250) / 3600 + 50 * 2 * 12.5 / 3600 plusOrMinus 0.3)
        }
    }

    test("a log that begins enabled, or ends while the battery recovers, has no voltage at rest at that end") {
        val use = logOf(seconds = 20..172).shouldNotBeNull()
        use.restBefore.shouldBeNull()
        use.restAfter.shouldBeNull()
    }

    test("energy that is unknown for more than a tenth of the time is not stated") {
        logOf { if (it < 160) "60" else "" }?.energy.shouldNotBeNull()
        logOf { if (it < 140) "60" else "" }?.energy.shouldBeNull()
    }

    test("the battery's name is in a value of the header, under any name that teams use") {
        for (name in listOf("Battery", "BatteryName", "battery_id", "Robot/Battery Number")) logOf(values = mapOf(name to " A1 "))?.name shouldBe "A1"
    }

    test("the battery's name is the last meaningful text of its topic") {
        logOf(texts = "Battery Name" to listOf("unknown", "A1", "B2", ""))?.name shouldBe "B2"
        logOf(texts = "/RealMetadata/BatteryName" to listOf("BAT-001"))?.name shouldBe "BAT-001"
        logOf(texts = "Battery Number" to listOf("7"))?.name shouldBe "7"
    }

    test("a voltage, or a text without meaning, is not a name") {
        for (text in listOf("12.4", "12.4 V", "12.4 volts", "unknown", "", "0")) logOf(values = mapOf("Battery" to text))?.name.shouldBeNull()
        logOf(values = mapOf("Battery Name" to "none"))?.name.shouldBeNull()
    }
})
