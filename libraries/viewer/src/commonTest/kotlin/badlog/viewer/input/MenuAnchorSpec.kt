package badlog.viewer.input

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class MenuAnchorSpec : FunSpec({
    fun corner(left: Int, top: Int, height: Int = 100) = MenuAnchor(left.toFloat(), top.toFloat(), top + 20f).cornerOf(width = 200, height, roomX = 800, roomY = 600)

    test("a menu is below its button, above it at the lower edge of the window, and as low as it fits if it fits nowhere") {
        corner(left = 300, top = 50) shouldBe (300f to 70f)
        corner(left = 300, top = 550) shouldBe (300f to 450f)
        corner(left = 300, top = 300, height = 400) shouldBe (300f to 200f)
    }

    test("a menu ends at the right edge of the window, and begins at its corner if it is larger") {
        corner(left = 780, top = 50) shouldBe (600f to 70f)
        corner(left = -10, top = 50, height = 700) shouldBe (0f to 0f)
    }
})
