package badlog.signals.derived

import badlog.core.analysis.Series
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe

class SightErrorSpec : FunSpec({
    val times = timesFor(20)

    /** A picture in each 0.1 s, of a robot at (2, 3) that believes to be [wrong] m aside. */
    fun error(wrong: (Double) -> Double, seen: (Int) -> Double): Series {
        val pictures = DoubleArray(200) { it / 10.0 + 0.05 }
        val x = Series(pictures, DoubleArray(200, seen))
        val y = Series(pictures, DoubleArray(200) { 3 + 0.001 * (it % 7) })
        return sightError(x to y, times.series { 2 + wrong(it) } to times.series { 3.0 })
    }

    test("a picture that no other agrees with is off by its whole distance") {
        error({ 0.0 }) { if (it == 100) 4.0 else 2.0 }.most() shouldBe (2.0 plusOrMinus 0.02)
    }

    test("pictures that agree with each other are right, and the estimate of the robot is wrong") {
        error({ if (it in 8.0..12.0) 1.5 else 0.0 }) { 2.0 }.run {
            most(8.2, 11.8) shouldBeLessThan 0.1
            most(to = 7.9) shouldBeLessThan 0.1
        }
    }

    test("a time between pictures is not a picture that agrees") {
        error({ 0.0 }) {
            if (it % 2 == 1) {
                Double.NaN
            } else if (it == 100) {
                4.0
            } else {
                2.0
            }
        }.most() shouldBe (2.0 plusOrMinus 0.02)
    }
})
