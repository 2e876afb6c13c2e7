package badlog.window.screen

import badlog.catalog.folder.putSamples
import badlog.window.sidebar.MainView
import badlog.window.theme.Theme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import java.awt.event.KeyEvent
import java.nio.file.Files

@Tags("InCheck")
class LibraryWindowSpec : FunSpec({
    test("a folder shows its newest log, its logs as rows and as a table, and the sheet of keys").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek")).also { it.putSamples(areSettled = true) }
        RealWindow(tempdir().toPath(), folder).use { window ->
            window.awaitState("all logs, and one of them") { it.library.state.entries.size == 4 && it.current.recording != null }
            window.awaitGraphs()
            window.click("Theme: system")
            window.awaitState("the dark theme") { it.settings.state.theme == Theme.DARK }
            window.awaitGraphs()
            window.picture("dark")
            window.press(KeyEvent.VK_T)
            window.awaitText("Table of logs")
            window.picture("table-dark")
            window.click("Theme: dark")
            window.awaitState("what the rules found") { viewer -> viewer.library.state.entries.all { it.found != null || it.isGray } }
            window.picture("table", guide = "viewer-logs")
            window.press(KeyEvent.VK_T)
            window.awaitState("the graphs") { it.panels.state.main == MainView.GRAPHS }
            window.press(KeyEvent.VK_F1)
            window.awaitText("Keys and gestures sheet")
            window.picture("help")
            window.press(KeyEvent.VK_ESCAPE)
            window.awaitState("no sheet") { !it.panels.state.help }
        }
    }
})
