package badlog.signals.clock

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.PropertyTesting
import kotlin.random.Random

class ClockPlaceSpec : FunSpec({
    test("a log that fits any other one has its place, with the errors of the way") {
        val fits = mapOf((1 to 0) to ClockFit(5.0, 3, 0.01), (2 to 1) to ClockFit(-2.0, 2, 0.02), (2 to 3) to ClockFit(0.0, 9, 0.0))
        val places = onOneClock(4, mapOf(0 to 100.0)) { own, other -> fits[own to other] }
        places.map { it?.seconds } shouldBe listOf(100.0, 105.0, 103.0, null)
        places[2]?.fit?.error shouldBe (0.03 plusOrMinus 1e-9)
    }

    test("whatever the logs' order, each has the offset of its clock, as long as those that fit hang together") {
        val random = Random(77)
        repeat(PropertyTesting.defaultIterationCount) {
            val count = random.nextInt(1, 9)
            val clocks = List(count) { random.nextDouble(-1000.0, 1000.0) }
            // Each log but the first fits at least one before it.
            val related = (1 until count).flatMap { own -> listOf(random.nextInt(own), random.nextInt(own)).map { own to it } }.toSet()
            val order = (0 until count).shuffled(random)
            val places = onOneClock(count, mapOf(order.indexOf(0) to 0.0)) { own, other ->
                val (one, two) = order[own] to order[other]
                if ((one to two) in related || (two to one) in related) ClockFit(clocks[two] - clocks[one], 2, 0.0) else null
            }
            places.forEachIndexed { index, place -> place?.seconds shouldBe (clocks[0] - clocks[order[index]] plusOrMinus 1e-6) }
        }
    }
})
