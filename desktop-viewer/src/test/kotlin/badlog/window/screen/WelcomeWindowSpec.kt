package badlog.window.screen

import badlog.window.theme.Theme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.awt.event.KeyEvent

@Tags("InCheck")
class WelcomeWindowSpec : FunSpec({
    test("the first start shows the welcome, and the keyboard alone opens the sample").config(enabledOrReasonIf = { needsDisplay }) {
        RealWindow(tempdir().toPath(), opened = null, width = 1366, height = 768).use { window ->
            window.awaitText("Welcome")
            window.picture("welcome", guide = "viewer-welcome")
            window.click("Show the lines in C++")
            window.click("Theme: system")
            window.awaitState("the dark theme") { it.settings.state.theme == Theme.DARK }
            window.picture("welcome-dark")
            window.tabTo("Open the sample match")
            window.picture("welcome-keyboard")
            window.press(KeyEvent.VK_ENTER)
            window.awaitState("the sample") { it.current.recording != null }
            window.awaitGraphs()
            window.awaitNo("Welcome")
            window.picture("welcome-sample")
        }
    }

    test("the welcome fits a small window, and one as narrow as a phone").config(enabledOrReasonIf = { needsDisplay }) {
        for ((width, height) in listOf(900 to 600, 420 to 800)) {
            RealWindow(tempdir().toPath(), opened = null, width, height).use { window ->
                window.awaitText("Open the sample match")
                window.picture("welcome-$width")
                window.click("Open the sample match")
                window.awaitState("the sample") { it.current.recording != null }
            }
        }
    }
})
