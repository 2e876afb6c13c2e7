package badlog.signals.battery

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlin.math.abs
import kotlin.math.sqrt
import kotlin.random.Random

class MeanResistanceSpec : FunSpec({
    test("one match is its own mean, and a list without matches has no mean") {
        meanOf(listOf(Resistance(20.0, 1.0))).shouldNotBeNull().run {
            milliohms shouldBe (20.0 plusOrMinus 1e-9)
            uncertainty shouldBe (1.0 plusOrMinus 1e-9)
        }
        meanOf(emptyList()).shouldBeNull()
    }

    test("matches that agree make it more certain, and the more certain ones count more") {
        val mean = meanOf(listOf(Resistance(20.0, 1.0), Resistance(20.5, 1.0), Resistance(20.2, 0.1))).shouldNotBeNull()
        mean.milliohms shouldBe (20.2 plusOrMinus 0.05)
        mean.uncertainty shouldBe (0.1 plusOrMinus 0.01)
    }

    test("matches that disagree make it less certain than each of them alone") {
        meanOf(listOf(Resistance(18.0, 0.2), Resistance(22.0, 0.2), Resistance(20.0, 0.2))).shouldNotBeNull().uncertainty shouldBeGreaterThan 2.0
    }

    for ((matches, between) in listOf(2 to 0.0, 3 to 0.0, 5 to 1.0, 10 to 1.0, 20 to 0.3)) {
        test("of 1000 batteries with $matches matches that differ by $between mΩ, about 95 % have the resistance that is stated") {
            val random = Random(5)
            fun normal() = List(12) { random.nextDouble() }.sum() - 6
            val covered = (0 until 1000).count {
                val truth = 15 + 10 * random.nextDouble()
                val seen = List(matches) {
                    val error = 0.1 + 0.5 * random.nextDouble()
                    Resistance(truth + sqrt(error * error + between * between) * normal(), 1.95996 * error)
                }
                meanOf(seen).shouldNotBeNull().run { abs(milliohms - truth) <= uncertainty }
            }
            covered shouldBeInRange 930..985
        }
    }
})
