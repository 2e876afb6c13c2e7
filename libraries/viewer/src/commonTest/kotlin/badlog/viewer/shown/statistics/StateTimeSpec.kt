package badlog.viewer.shown.statistics

import badlog.core.analysis.Series
import badlog.core.analysis.StateRuns
import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class StateTimeSpec : FunSpec({
    val names = listOf("off", "on", "stuck")

    fun runs(vararg states: Double) = StateRuns(Series(DoubleArray(states.size) { it.toDouble() }, states), states.size.toDouble())
    fun List<StateTime>.parts() = map { Triple(it.state, it.time, it.count) }

    test("each state has its time and its count, the longest first") {
        val runs = runs(0.0, 1.0, 0.0, 0.0, 1.0)
        runs.timesOf(names).parts() shouldBe listOf(Triple("off", 3.0, 2), Triple("on", 2.0, 2))
        runs.timesOf(names)[0].share shouldBe (0.6 plusOrMinus 1e-12)
    }

    test("only runs inside a range count, not ones that touch it") {
        runs(0.0, 1.0, 0.0, 0.0, 1.0).timesOf(names, 1.5, 4.0).parts() shouldBe listOf(Triple("off", 2.0, 1), Triple("on", 0.5, 1))
        runs(0.0, 1.0).timesOf(names, 7.0, 9.0) shouldBe emptyList()
    }

    test("a gap does not count for any state") {
        runs(0.0, Double.NaN, 0.0).timesOf(names).parts() shouldBe listOf(Triple("off", 2.0, 2))
    }

    test("texts have the unit of x, or rows if x counts rows") {
        val seconds = bagView(listOf("Time|xaxis", "A"), listOf("0,1")).xAxis
        val rows = bagView(listOf("A"), listOf("1")).xAxis
        StateTime("on", 4.25, 0.027, 3).text(seconds) shouldBe "on 4.25 V (2.7 %), 3 times"
        StateTime("on", 4.0, Double.NaN, 1).text(rows) shouldBe "on 4 rows (–), 1 time"
        StateTime("on", 1.0, Double.NaN, 1).text(rows) shouldBe "on 1 row (–), 1 time"
    }

    test("the times of all states add up to the whole time, and their shares to one") {
        checkAll(Arb.list(Arb.int(0..2), 1..60), Arb.int(0..30), Arb.int(1..40)) { states, from, length ->
            val runs = runs(*DoubleArray(states.size) { states[it].toDouble() })
            val to = (from + length).toDouble()
            val times = runs.timesOf(names, from.toDouble(), to)
            val seen = maxOf(0.0, minOf(to, states.size.toDouble()) - from)
            times.sumOf { it.time } shouldBe (seen plusOrMinus 1e-9)
            if (seen > 0) times.sumOf { it.share } shouldBe (1.0 plusOrMinus 1e-9)
            if (seen > 0) times.map { it.state }.toSet() shouldBe states.drop(from).take(length).map { names[it] }.toSet()
        }
    }
})
