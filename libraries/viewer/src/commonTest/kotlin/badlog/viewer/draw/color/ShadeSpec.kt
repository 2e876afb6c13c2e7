package badlog.viewer.draw.color

import badlog.viewer.draw.mark.RobotMode
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import kotlin.math.pow

/** The contrast of two colors, from 1 to 21, as the guidelines for accessible pages define it. */
private fun contrast(one: Int, other: Int): Double {
    val brightness = listOf(one, other).map { color ->
        val (red, green, blue) = listOf(16, 8, 0).map { shift ->
            val share = ((color shr shift) and 0xFF) / 255.0
            if (share <= 0.04045) share / 12.92 else ((share + 0.055) / 1.055).pow(2.4)
        }
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }
    return (brightness.max() + 0.05) / (brightness.min() + 0.05)
}

/** The color of [color] with the opacity [share] over [ground]. */
private fun mixed(color: Int, ground: Int, share: Double): Int {
    var mixed = 0
    for (shift in listOf(16, 8, 0)) {
        val part = ((color shr shift) and 0xFF) * share + ((ground shr shift) and 0xFF) * (1 - share)
        mixed = mixed or (part.toInt() shl shift)
    }
    return mixed
}

class ShadeSpec : FunSpec({
    test("style sheets get all digits of a color, and of any opacity") {
        cssColor(0x0B62C4) shouldBe "#0b62c4"
        cssColor(0xFF, 0.5) shouldBe "#0000ff7f"
        cssColor(0xFFFFFF, 0.05) shouldBe "#ffffff0c"
        cssColor(0, 0.0) shouldBe "#00000000"
    }

    for (isDark in listOf(false, true)) {
        val theme = if (isDark) "dark" else "light"

        test("text is readable on all its backgrounds, in the $theme theme") {
            val behind = listOf(Shade.SURFACE, Shade.PAGE, Shade.RAISED)
            val soft = mapOf(Shade.ERROR to Shade.ERROR_SOFT, Shade.WARNING to Shade.WARNING_SOFT, Shade.ACCENT to Shade.ACCENT_SOFT)
            for (text in listOf(Shade.TEXT, Shade.MUTED, Shade.ACCENT, Shade.EVENT, Shade.ERROR, Shade.WARNING)) {
                for (ground in behind + listOfNotNull(soft[text])) contrast(text.of(isDark), ground.of(isDark)) shouldBeGreaterThan 4.5
            }
            contrast(Shade.STATE_TEXT.of(isDark), Shade.STATE_OFF.of(isDark)) shouldBeGreaterThan 7.0
        }

        test("the state of a lane is readable in every color, in the $theme theme") {
            for (index in 0 until LINE_COLORS) {
                val ground = mixed(lineColor(index, isDark), Shade.SURFACE.of(isDark), stateOpacity(isDark))
                contrast(Shade.STATE_TEXT.of(isDark), ground) shouldBeGreaterThan 4.5
            }
        }

        test("the shadings of the modes can be distinguished, and leave text and lines readable, in the $theme theme") {
            val grounds = RobotMode.entries.filter { it != RobotMode.TEST }.map { mixed(modeShade(it).of(isDark), Shade.SURFACE.of(isDark), modeOpacity(isDark)) }
            grounds.shouldBeUnique()
            for (ground in grounds) {
                contrast(Shade.TEXT.of(isDark), ground) shouldBeGreaterThan 7.0
                for (index in 0 until LINE_COLORS) contrast(lineColor(index, isDark), ground) shouldBeGreaterThan 2.0
            }
            // Blue against yellow: people who cannot distinguish green from red can distinguish these.
            (grounds[0] and 0xFF) shouldBeLessThan (grounds[1] and 0xFF) - 15
        }

        test("the lines' colors all differ, and are visible on a graph, in the $theme theme") {
            val colors = List(LINE_COLORS) { lineColor(it, isDark) }
            colors.shouldBeUnique()
            for (color in colors) contrast(color, Shade.SURFACE.of(isDark)) shouldBeGreaterThan 2.5
        }
    }
})
