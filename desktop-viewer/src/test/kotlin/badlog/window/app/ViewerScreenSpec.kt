package badlog.window.app

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.window.theme.Theme
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
class ViewerScreenSpec : FunSpec({
    val home = tempdir().toPath()

    test("each click on the theme changes the visible colors") {
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        runDesktopComposeUiTest(1200, 800) {
            setContent { ViewerScreen(viewer) }
            onNodeWithText("badlog").assertExists()
            onNodeWithContentDescription("Theme: system").performClick()
            viewer.settings.state.theme shouldBe Theme.DARK
            onNodeWithContentDescription("Theme: dark").performClick()
            viewer.settings.state.theme shouldBe Theme.SYSTEM
        }
    }

    test("a theme chosen under other system colors switches to the opposite colors") {
        Theme.DARK.other(isSystemDark = true) shouldBe Theme.LIGHT
        Theme.LIGHT.other(isSystemDark = true) shouldBe Theme.SYSTEM
        Theme.LIGHT.other(isSystemDark = false) shouldBe Theme.DARK
    }
})
