package badlog.window.theme

import androidx.compose.foundation.layout.width
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.font.createFontFamilyResolver
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import androidx.compose.ui.unit.sp
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith

class NameTextSpec : FunSpec({
    val name = "Drivetrain/Module 3/Azimuth encoder position of the absolute sensor"
    val style = TextStyle(fontSize = 13.sp)

    /** Runs [check] with a measurer of letters on a screen. */
    fun measuring(check: TextMeasurer.() -> Unit) = TextMeasurer(createFontFamilyResolver(), Density(1f), LayoutDirection.Ltr).check()

    fun TextMeasurer.shown(text: String, width: Int, cut: NameCut) = measureName(AnnotatedString(text), style, width, cut).layoutInput.text.text

    test("a name that fits is drawn whole") {
        measuring { NameCut.entries.forEach { shown(name, 5_000, it) shouldBe name } }
    }

    test("a name that is too long loses its beginning, fits, and uses the room") {
        measuring {
            for (width in 30..400 step 7) {
                val layout = measureName(AnnotatedString(name), style, width, NameCut.BEGINNING)
                val text = layout.layoutInput.text.text
                text shouldStartWith "…"
                name shouldEndWith text.drop(1)
                layout.size.width shouldBeLessThanOrEqual width
                layout.size.width shouldBeGreaterThan width - 20
            }
        }
    }

    test("a name cut in its middle keeps both ends") {
        measuring {
            for (width in 60..400 step 7) {
                val layout = measureName(AnnotatedString(name), style, width, NameCut.MIDDLE)
                val (head, tail) = layout.layoutInput.text.text.split("…")
                name shouldStartWith head
                name shouldEndWith tail
                head.length shouldBeGreaterThan 0
                tail.length shouldBeGreaterThan 0
                layout.size.width shouldBeLessThanOrEqual width
            }
        }
    }

    test("the name of a log's file loses whole words in its middle") {
        val file = "FRC_20260307_163005_OHCL_Q57.wpilog"
        val words = file.split('_', '.')
        measuring {
            for (width in 160..200 step 5) shown(file, width, NameCut.FILE).split('_', '.', '…').filter { it.isNotEmpty() && it !in words } shouldBe emptyList()
        }
    }

    test("derivatives, which all end the same, keep the name of their topic") {
        measuring {
            val (left, right) = listOf("Left", "Right").map { "[ $it Position Derivative ]" }
            shown(left, 120, NameCut.of(left)) shouldStartWith "[ Le"
            shown(right, 120, NameCut.of(right)) shouldStartWith "[ Ri"
            NameCut.of(name) shouldBe NameCut.BEGINNING
        }
    }

    test("an event keeps its last words whole, or as many letters of the last one as fit") {
        measuring {
            val event = "Millstone District Regional"
            val texts = (60..200).map { shown(event, it, NameCut.WORDS) }
            texts.filter { it.length > "…Regional".length }.toSet() - event shouldBe setOf("…District Regional")
            texts shouldContain "…Regional"
            texts shouldContain "…District Regional"
            event shouldEndWith shown(event, 40, NameCut.WORDS).drop(1)
            shown(event, 40, NameCut.WORDS).length shouldBeGreaterThan 2
        }
    }

    test("a letter of two characters is never halved") {
        measuring {
            for (width in 30..200 step 5) {
                val text = shown("🤖".repeat(60), width, NameCut.MIDDLE)
                text shouldContain "…"
                text.replace("🤖", "") shouldBe "…"
            }
        }
    }

    test("a name without any room does not fail") {
        measuring { for (width in 0..30) for (cut in NameCut.entries) shown(name, width, cut) shouldNotContain "Drivetrain" }
    }
})
