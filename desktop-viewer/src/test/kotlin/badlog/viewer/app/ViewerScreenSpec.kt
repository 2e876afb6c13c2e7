package badlog.viewer.app

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.settings.UserFolders
import badlog.viewer.theme.Theme
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
class ViewerScreenSpec : FunSpec({
    val home = tempdir().toPath()

    test("the theme goes round from that of the system to light and dark") {
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        runDesktopComposeUiTest(1200, 800) {
            setContent { ViewerScreen(viewer) }
            onNodeWithText("badlog").assertExists()
            onNodeWithContentDescription("Theme: system").performClick()
            viewer.settings.state.theme shouldBe Theme.LIGHT
            onNodeWithContentDescription("Theme: light").performClick()
            viewer.settings.state.theme shouldBe Theme.DARK
        }
    }
})
