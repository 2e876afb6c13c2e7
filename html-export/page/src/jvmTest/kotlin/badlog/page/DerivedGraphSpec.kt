package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import org.openqa.selenium.By
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class DerivedGraphSpec : PageSpec({
    // At 0, 1, 2 and 4 s. Slopes 2, 4 and 0 at 0.5, 1.5 and 3 s; areas 1, 4 and 12.
    val times = listOf(0, 1, 2, 4)
    val positions = listOf(0, 2, 6, 6)
    val derived by lazy {
        val topics = listOf(TIME, BagTopic("Arm/Position", "m", listOf("delta", "differentiate", "integrate")))
        TestPages.of(bagOf(topics, 4) { row, column -> if (column == 0) times[row] else positions[row] })
    }

    fun OpenPage.partOf(title: String, part: String): String {
        val card = elements(".graph").single { it.findElement(By.cssSelector(".graph-title")).text == title }
        return card.findElement(By.cssSelector(part)).text
    }

    fun OpenPage.valueOf(title: String) = partOf(title, ".value")

    fun OpenPage.unitOf(title: String) = partOf(title, ".graph-unit")

    browserTest("derivative, delta and integral equal values calculated by hand, at their own samples and with their own units") {
        onPage(derived) {
            unitOf("[ Position Derivative ]") shouldBe "m/s"
            unitOf("[ Position Delta ]") shouldBe "m"
            unitOf("[ Position Integral ]") shouldBe "m·s"
            for ((across, slope) in listOf(0.125 to "2", 0.375 to "4", 0.75 to "0")) {
                graph("Arm/Position").scrollTo().hover(across)
                valueOf("[ Position Derivative ]") shouldBe slope
                valueOf("[ Position Delta ]") shouldBe slope
            }
            graph("Arm/Position").scrollTo().hover(0.001)
            val sums = List(4) { step ->
                if (step > 0) press(Keys.ARROW_RIGHT)
                valueOf("[ Position Integral ]")
            }
            sums shouldBe listOf("0", "1", "5", "17")
        }
    }

    // Both run from 100 to 110 V.
    val shapes by lazy {
        val topics = listOf(
            TIME,
            BagTopic("Plain", "V"),
            BagTopic("Zero", "V", listOf("zero")),
            BagTopic("Area", "V", listOf("area", "zero")),
        )
        TestPages.of(bagOf(topics, 101) { row, column -> if (column == 0) row else 100 + row / 10.0 })
    }

    /** Returns the highest and lowest position of the line, as shares of the frame from its top. */
    fun OpenPage.heights(name: String): Pair<Double, Double> {
        val rows = graph(name).picture.rowsOf(color("--line-0"))
        val drawn = rows.indices.filter { rows[it] > 0 }
        return drawn.first().toDouble() / rows.size to drawn.last().toDouble() / rows.size
    }

    browserTest("zero only adds 0 to the y axis, and area fills the space below the line") {
        onPage(shapes) {
            val (plainTop, plainBottom) = heights("Plain")
            plainTop shouldBe (0.06 plusOrMinus 0.06)
            plainBottom shouldBe (0.94 plusOrMinus 0.06)
            val (zeroTop, zeroBottom) = heights("Zero")
            zeroTop shouldBe (0.06 plusOrMinus 0.04)
            // 100 of 110 V.
            (1 - zeroBottom) / (1 - zeroTop) shouldBe (100.0 / 110 plusOrMinus 0.03)
            graph("Area").picture.opacityAt(0.53, 0.53) shouldBeGreaterThan graph("Zero").picture.opacityAt(0.53, 0.53)
            graph("Zero").picture.opacityAt(0.53, 0.53) shouldBe 0
        }
    }
})
