package badlog.core.analysis

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SeriesSpec : FunSpec({
    val ordered = Series(doubleArrayOf(0.0, 1.0, 1.0, 4.0), doubleArrayOf(1.0, 2.0, 3.0, 4.0))

    test("nearest finds the sample nearest to a position, the earlier of two") {
        listOf(-5.0, 0.4, 0.5, 0.6, 2.5, 2.6, 99.0).map(ordered::nearest) shouldBe listOf(0, 0, 0, 1, 2, 3, 3)
        Series(DoubleArray(0), DoubleArray(0)).nearest(1.0) shouldBe -1
    }

    test("nearest finds the nearest sample even if x goes backwards") {
        Series(doubleArrayOf(5.0, 6.0, 0.0, 1.0), DoubleArray(4)).nearest(0.9) shouldBe 3
    }

    test("the range has the least and greatest x in any order") {
        ordered.range shouldBe 0.0..4.0
        Series(doubleArrayOf(5.0, 6.0, 0.0), DoubleArray(3)).range shouldBe 0.0..6.0
        Series(DoubleArray(0), DoubleArray(0)).range shouldBe null
    }

    test("x and y of different sizes are refused") {
        shouldThrow<IllegalArgumentException> { Series(DoubleArray(2), DoubleArray(3)) }
    }
})
