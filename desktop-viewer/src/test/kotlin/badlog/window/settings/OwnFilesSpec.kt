package badlog.window.settings

import badlog.catalog.folder.putSamples
import badlog.files.UserFolders
import badlog.window.app.Viewer
import badlog.window.change
import badlog.window.theme.Theme
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancel
import java.nio.file.Files

@Tags("InCheck")
class OwnFilesSpec : FunSpec({
    /** Stores everything for the next start of a viewer with [folders], and returns its notices. */
    fun saidWith(folders: UserFolders, steps: suspend (Viewer) -> Unit = {}): List<String> {
        val viewer = Viewer(MainScope(), folders)
        try {
            onWindowThread {
                viewer.start()
                viewer.library.open(tempdir().toPath().also { it.putSamples() })
                awaitState { viewer.current.recording != null && viewer.library.state.reading == null }
                viewer.settings.change { copy(theme = Theme.DARK) }
                steps(viewer)
                viewer.board.change { withGraph(listOf("Drivetrain/Left Output")) }
                // Saves like the window does by itself a moment later.
                viewer.layouts.save()
            }
            return viewer.notices.all.map { it.text }
        } finally {
            viewer.library.close()
            viewer.scope.cancel()
        }
    }

    test("a home folder that cannot be written is reported in one sentence, and the window works") {
        val home = Files.createFile(tempdir().toPath().resolve("home"))
        saidWith(UserFolders(home.resolve(".config/badlog"), home.resolve(".cache/badlog"))) { viewer ->
            viewer.openSample()
            awaitState { viewer.current.recording?.file?.fileName.toString() == "qualification-42.bag.gz" }
        } shouldContainExactly listOf(
            "Settings, layouts and stored results for logs cannot be kept for the next start; " +
                "rename the file $home, because a folder must be there.",
        )
    }

    test("files that can be written are not mentioned") {
        val folder = tempdir().toPath()
        val cache = Files.createFile(folder.resolve("cache"))
        val settings = SettingsFile(folder.resolve("config/badlog").resolve(SettingsFile.NAME))
        saidWith(UserFolders(folder.resolve("config/badlog"), cache)) { awaitState { settings.read().theme == Theme.DARK } } shouldContainExactly
            listOf("Stored results for logs cannot be kept for the next start; rename the file $cache, because a folder must be there.")
    }

    test("a file that cannot be replaced in a writable folder is reported once, too") {
        val home = tempdir().toPath()
        Files.createDirectories(home.resolve("${SettingsFile.NAME}/in the way"))
        val said = saidWith(UserFolders(home, home)) { viewer -> awaitState { viewer.notices.all.isNotEmpty() } }
        said.size shouldBe 1
        said.single().startsWith("Settings and layouts cannot be saved: ${home.resolve(SettingsFile.NAME)} cannot be") shouldBe true
    }
})
