package badlog.rules.number

import badlog.core.analysis.Series
import badlog.signals.match.MatchKind
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe

class DistributionSpec : FunSpec({
    val binned = DistributedSignal("loop time", above = 0.0, binWidth = 1.0, bins = 61)

    fun of(values: List<Double>, weights: List<Double> = values.map { 1.0 }, signal: DistributedSignal = binned, least: Double = 1.0) = signal.of(Series(DoubleArray(values.size) { it.toDouble() }, values.toDoubleArray()), weights.toDoubleArray(), "ms", second = 1.0, least)

    test("quantiles are shares of the time, not of the samples") {
        val loops = checkNotNull(of(listOf(5.0, 100.0), listOf(96.0, 4.0)))
        listOf(loops.lowest, loops.percentile5, loops.lowerQuartile, loops.median, loops.upperQuartile, loops.percentile95, loops.highest) shouldBe
            listOf(5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 100.0)
    }

    test("each bin has the time in it, and the last one everything larger") {
        val loops = checkNotNull(of(listOf(0.0, 7.2, 7.9, 60.0, 5000.0), listOf(1.0, 2.0, 3.0, 4.0, 5.0)))
        loops.seconds.size shouldBe 61
        loops.seconds[0] shouldBe 1.0
        loops.seconds[7] shouldBe 5.0
        loops.seconds[60] shouldBe 9.0
        loops.seconds.sum() shouldBe (15.0 plusOrMinus 1e-9)
    }

    test("values from before the first voltage do not count: a library logs 0 then") {
        val battery = DistributedSignal("battery", above = 1.0)
        val volts = checkNotNull(of(listOf(0.0, 12.0, Double.NaN, 11.0), signal = battery))
        volts.lowest shouldBe 11.0
        volts.seconds shouldBe emptyList()
    }

    test("a time that is too short, or zero, has no distribution") {
        of(listOf(5.0, 6.0), least = 3.0) shouldBe null
        of(listOf(5.0, 6.0), listOf(0.0, 0.0), least = 0.0) shouldBe null
        of(emptyList(), least = 0.0) shouldBe null
    }

    test("distributions are read as they were written, and a damaged line is left out") {
        val loops = checkNotNull(of(listOf(5.5, 7.25, 33.0, 70.0)))
        val text = LogNumbers(MatchKind.MATCH, emptyList(), DoubleArray(0), Double.NaN, distributions = listOf(loops)).toText()
        val back = checkNotNull(LogNumbersReader().read(text).distributionOf("loop time"))
        back.quantiles shouldBe loops.quantiles
        back.seconds shouldBe loops.seconds
        back.unit shouldBe "ms"
        fun read(distributions: String) = LogNumbersReader().read(LogNumbersText(text.names, text.values, distributions)).distributions.size
        for (damaged in listOf("", "x", "loop time\tms\t1;2\t1.0\t3*", text.distributions.replace("*", "x"), text.distributions.replace("5*", "5000000000*"))) {
            read(damaged) shouldBe 0
        }
    }
})
