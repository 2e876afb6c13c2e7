package badlog.page.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class CursorSpec : FunSpec({
    test("steps from sample to sample, over rows that share a time") {
        val cursor = Cursor(listOf(doubleArrayOf(0.0, 1.0, 1.0, Double.NaN, 2.0, 3.0)))
        cursor.step(1, 0.9)
        cursor.x shouldBe 1.0
        cursor.step(1, 0.0)
        cursor.x shouldBe 2.0
        cursor.step(-1, 0.0)
        cursor.x shouldBe 1.0
        cursor.step(10, 0.0)
        cursor.x shouldBe 3.0
        cursor.place(1.5)
        cursor.step(-1, 0.0)
        cursor.x shouldBe 1.0
    }

    test("steps over the samples of all clocks") {
        val cursor = Cursor(listOf(doubleArrayOf(0.0, 2.0), doubleArrayOf(1.0, 2.0, 5.0), doubleArrayOf()))
        cursor.step(1, 0.2)
        cursor.x shouldBe 0.0
        val places = List(4) {
            cursor.step(1, 0.0)
            cursor.x
        }
        places shouldBe listOf(1.0, 2.0, 5.0, 5.0)
        cursor.step(-1, 0.0)
        cursor.x shouldBe 2.0
        cursor.step(-9, 0.0)
        cursor.x shouldBe 0.0
    }
})
