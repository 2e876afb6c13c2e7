package badlog.core.analysis

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class StateRunsSpec : FunSpec({
    fun runs(x: List<Double>, y: List<Double>, end: Double) = StateRuns(Series(x.toDoubleArray(), y.toDoubleArray()), end)

    fun StateRuns.texts() = List(states.size) { "${states[it]}: ${from[it]}..${to[it]}" }

    test("a state lasts until the next one, and the last until the end") {
        val x = listOf(0.5, 1.5, 2.5, 3.5)
        runs(x, listOf(4.0, 4.0, 2.0, 2.0), 9.5).texts() shouldBe listOf("4: 0.5..2.5", "2: 2.5..9.5")
    }

    test("gaps belong to no state") {
        val x = listOf(0.5, 1.5, 2.5)
        runs(x, listOf(4.0, Double.NaN, 4.0), 2.5).texts() shouldBe listOf("4: 0.5..1.5", "4: 2.5..2.5")
    }

    test("where x jumps back, a state ends at its last sample") {
        val x = listOf(5.5, 6.5, 1.5)
        runs(x, listOf(1.0, 1.0, 1.0), 6.5).texts() shouldBe listOf("1: 5.5..6.5", "1: 1.5..6.5")
    }
})
