package badlog.viewer.menu

import androidx.compose.foundation.layout.Box
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.keyboard.Keyboard
import badlog.viewer.theme.Icons
import badlog.viewer.theme.Theme
import badlog.viewer.theme.ViewerTheme
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class OpenMenusSpec : FunSpec({
    test("Escape closes the menu that is open, and nothing else while one is") {
        val keyboard = Keyboard()
        runDesktopComposeUiTest(400, 300) {
            setContent {
                ViewerTheme(Theme.LIGHT) {
                    keyboard.Watch { Box { Menu("Export", "Export menu", Icons.Graph) { listOf(MenuEntry("Save page") {}) } } }
                }
            }
            keyboard.menus.closeLast() shouldBe false
            onNodeWithContentDescription("Export menu").performClick()
            onNodeWithContentDescription("Save page").assertExists()
            runOnIdle { keyboard.menus.closeLast() shouldBe true }
            onNodeWithContentDescription("Save page").assertDoesNotExist()
            runOnIdle { keyboard.menus.closeLast() shouldBe false }
        }
    }
})
