package badlog.expression

import badlog.core.analysis.Series
import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun signals(timeUnit: String = "s"): SampleSignals {
    val x = DoubleArray(4) { if (timeUnit == "ms") it * 1000.0 else it.toDouble() }
    fun line(name: String, unit: String, vararg y: Double) = Signal(name, SignalKind.NUMBER, unit) to Series(x, y)
    return SampleSignals(
        mapOf(
            line("Loop Time", "ms", 5.0, 19.0, 21.0, 134.0),
            line("Plain", "", 5.0, 19.0, 21.0, 134.0),
            line("Voltage", "V", 12.0, 11.0, 6.5, 12.0),
            line("Rail", "mV", 3300.0, 3250.0, 11500.0, 3300.0),
            line("Height", "m", 0.0, 0.25, 0.5, 0.75),
            line("Speed", "ft/s", 0.0, 1.0, 2.0, 3.0),
            line("Angle", "deg", 0.0, 90.0, 180.0, 270.0),
            line("CAN", "fraction", 0.2, 0.5, 0.97, 0.3),
            line("CPU", "%", 20.0, 50.0, 97.0, 30.0),
            line("Knots", "kn", 1.0, 2.0, 3.0, 4.0),
        ),
        timeUnit = timeUnit,
    )
}

class UnitsSpec : FunSpec({
    val counts = mapOf(
        "count(Loop Time > 20 ms)" to 1, "total(Loop Time > 20 ms)" to 1, "total(Loop Time > 0.02 s)" to 1,
        "total(20 ms < Loop Time)" to 1, "total(Voltage < 7 V)" to 1, "total(Voltage < 7000 mV)" to 1, "total(Voltage < Rail)" to 1,
        "total(Height >= 25 cm)" to 2, "total(Height - 10 cm > 0.4)" to 0, "total(derivative(Height) > 0.2 m/s)" to 3,
        "total(derivative(Height) < 30 cm/s)" to 3, "total(Speed > 0.4 m/s)" to 1, "total(Angle > 1 rad)" to 2, "total(Angle > 0.2 rot)" to 2,
        "total(CAN > 90 %)" to 1, "total(CPU > 90 %)" to 1, "total(CPU > 90%)" to 1, "total(CPU % 20 > 9)" to 2,
        "total(CPU > 0.9 fraction)" to 1, "count(delta(Loop Time) > 100 ms)" to 1,
        "total(time > 1.5 s)" to 1, "total(time >= 0:01)" to 2, "total(if(true, Loop Time, 0) > 20 ms)" to 1,
        "total(clamp(Loop Time, 10 ms, 0.03 s) > 29 ms)" to 0,
    )
    for ((text, count) in counts) {
        for (timeUnit in listOf("s", "ms")) {
            test("$text is $count if x is in $timeUnit") {
                val signals = signals(timeUnit)
                val value = parsed(text, signals.vocabulary).answer(signals).quantities.single().value
                (if (timeUnit == "ms" && text.startsWith("total")) value / 1000 else value) shouldBe count.toDouble()
            }
        }
    }

    test("a converted number has its new unit") {
        val signals = signals()
        parsed("max(Voltage) > max(Rail)", signals.vocabulary).answer(signals).toString() shouldBe
            "yes, max(Voltage) = 12 V at 0 s, max(Rail) = 11.5 V at 2 s"
    }

    val mistakes = mapOf(
        "Plain > 20 ms" to ("20 ms" to "“Plain” has no unit, so 20 ms cannot be compared with it; write the number alone, as it is logged."),
        "Plain < 7 V" to ("7 V" to "“Plain” has no unit, so 7 V cannot be compared with it; write the number alone, as it is logged."),
        "Voltage > 20 ms" to ("20 ms" to "“Voltage” in V and 20 ms have units that cannot be converted into each other."),
        "Voltage < Loop Time" to ("Loop Time" to "“Voltage” in V and “Loop Time” in ms have units that cannot be converted into each other."),
        "Voltage + 3 A > 1" to ("3 A" to "“Voltage” in V and 3 A have units that cannot be converted into each other."),
        "Knots > 3 m/s" to ("3 m/s" to "“Knots” is in “kn”, to which 3 m/s cannot be converted; write the number alone."),
        "Voltage * 2 > 3 V" to ("3 V" to "The unit of the other side is not known, so 3 V cannot be compared with it; write the number alone."),
        "Voltage * Voltage > 3 W" to ("3 W" to "The unit of the other side is not known, so 3 W cannot be compared with it; write the number alone."),
        "Plain > 40 %" to ("40 %" to "“Plain” has no unit, so 40 % cannot be compared with it; write the number alone, as it is logged."),
        "Voltage < 7 zorks" to ("zorks" to "“zorks” is not a unit that badlog knows; times are written in h, min, s, ms or us, other numbers without a unit or as in 7 V."),
        "time > 1:75" to ("1:75" to "“1:75” is not a time; write minutes and seconds as 1:30, or hours too as 1:02:03."),
    )
    for ((text, mistake) in mistakes) {
        test("“$text” is a mistake") {
            val error = errorOf(text, signals().vocabulary)
            error.text.substring(error.from, error.until) shouldBe mistake.first
            error.message shouldBe mistake.second
        }
    }

    test("an expression with units is read back unchanged") {
        for (text in listOf("Voltage < 7 V", "CPU > 90 %", "time > 1:30", "Speed > 3 ft/s", "time > 1:02:03.5")) {
            val read = parsed(text, signals().vocabulary)
            parsed(read.toString(), signals().vocabulary).toString() shouldBe read.toString()
        }
    }
})
