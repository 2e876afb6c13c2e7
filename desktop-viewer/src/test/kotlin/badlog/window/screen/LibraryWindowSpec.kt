package badlog.window.screen

import badlog.catalog.folder.bag
import badlog.catalog.folder.put
import badlog.catalog.folder.putSamples
import badlog.catalog.folder.samples
import badlog.window.sidebar.MainView
import badlog.window.theme.Theme
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import java.awt.event.KeyEvent
import java.nio.file.Files
import java.nio.file.Path

class LibraryWindowSpec : FunSpec({
    test("a folder shows its newest log, its logs as rows and as a table, and the sheet of keys").config(
        enabledOrReasonIf = { needsDisplay },
    ) {
        val folder = Files.createDirectories(tempdir().toPath().resolve("Mill Creek")).also { it.putSamples() }
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

    test("an empty folder says what it waits for, and a log that comes is shown").config(enabledOrReasonIf = { needsDisplay }) {
        val folder = tempdir().toPath()
        RealWindow(tempdir().toPath(), folder).use { window ->
            window.awaitState("a look at the folder") { it.library.state.hasLooked }
            window.picture("empty-folder")
            folder.put("first.bag", bag())
            window.awaitText("Log first.bag")
            window.awaitState("the log") { it.current.recording?.file == folder.resolve("first.bag") }
            folder.put("later.bag", bag(300))
            window.awaitText("Log later.bag")
        }
    }

    test("a folder of broken files is listed, and each says what is wrong with it").config(enabledOrReasonIf = { needsDisplay }) {
        val folder = brokenFolder(tempdir().toPath())
        RealWindow(tempdir().toPath(), folder).use { window ->
            window.awaitState("all that can be listed") { viewer ->
                viewer.library.state.reading == null && viewer.library.state.entries.map { it.fileName }.toSet() ==
                    setOf("random.bag", "half.bag.gz", "empty.bag", "cut.bag", "inside.bag")
            }
            window.click("Log random.bag")
            window.awaitState("a sentence") { viewer -> viewer.notices.all.any { it.isError } }
            window.picture("broken-folder")
            window.click("Log half.bag.gz")
            window.awaitState("half a log") { it.current.recording?.file == folder.resolve("half.bag.gz") }
            for (name in listOf("random.bag", "directory.bag", "nowhere.bag")) {
                window.look { viewer ->
                    viewer.notices.all.toList().forEach { viewer.notices.dismiss(it.id) }
                    viewer.loader.open(folder.resolve(name))
                }
                window.awaitState("a sentence") { viewer -> viewer.notices.all.any { it.isError && name in it.text } }
            }
            window.look { it.current.recording?.file } shouldBe folder.resolve("half.bag.gz")
        }
    }
})

/** Puts into [folder] what logs must not be like. */
private fun brokenFolder(folder: Path): Path {
    Files.write(folder.resolve("random.bag"), ByteArray(5000) { (it * 31 + it / 7).toByte() })
    val packed = Files.readAllBytes(samples.resolve("qualification-57.bag.gz"))
    Files.write(folder.resolve("half.bag.gz"), packed.copyOf(packed.size / 2))
    folder.put("empty.bag", "")
    folder.put("cut.bag", bag(50).dropLast(20))
    folder.put("directory.bag/inside.bag", bag())
    // Reading a pipe that nobody writes into would never end.
    if (Files.exists(Path.of("/usr/bin/mkfifo"))) ProcessBuilder("mkfifo", "$folder/pipe.bag").start().waitFor()
    return folder
}
