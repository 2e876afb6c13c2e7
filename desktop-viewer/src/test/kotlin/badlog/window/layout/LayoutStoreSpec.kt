package badlog.window.layout

import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardLayout
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.folder.LibraryState
import badlog.window.kept
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import badlog.window.sidebar.Panels
import badlog.window.waiting.awaitShown
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.nio.file.Path

class LayoutStoreSpec : FunSpec({
    /** Starts the program again over [folder], and runs [then] once [recording] is opened. */
    fun started(home: Path, folder: Path, recording: OpenRecording, then: suspend (Viewer) -> Unit) {
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        onWindowThread {
            val following = listOf(launch { viewer.layouts.autosave() }, launch { viewer.shown.run() })
            viewer.library.change { LibraryState(folder) }
            awaitState { viewer.layouts.folder == folder }
            viewer.view.send(PlaceAction.Open(recording.span))
            viewer.current.replace(recording)
            viewer.layouts.showGraphs(recording)
            awaitState { viewer.board.state.graphs.isNotEmpty() }
            awaitShown(viewer)
            then(viewer)
            awaitState { !viewer.shown.isWaiting }
            viewer.layouts.saveNow()
            following.forEach { it.cancel() }
        }
    }

    suspend fun Viewer.opened(log: Path, folder: Path) = withContext(Dispatchers.IO) {
        OpenRecording.read(log, folder, choices = { RecordingChoices(layouts.formulasFor(log, it)) })
    }

    fun hasArranged(home: Path, folder: Path) = FolderLayouts(home.resolve("layouts")).read(folder)

    test("a reopened folder is arranged as it was left, whichever of its recordings is opened") {
        val home = tempdir().toPath()
        val folder = Files.createDirectories(home.resolve("logs"))
        val one = recordingOf(armBag(500), folder.resolve("one.bag"))
        val other = recordingOf(armBag(500), folder.resolve("other.bag"))
        started(home, folder, one) {
            it.board.replace(Board().withGraph(listOf("Arm/Current", "Arm/Mode")))
            it.view.send(PlaceAction.Show(2.0, 3.0))
            it.panels.change { Panels(topics = false) }
        }
        hasArranged(home, folder)?.graphs?.graphs?.map { it.lines } shouldBe listOf(listOf("Arm/Current", "Arm/Mode"))
        started(home, folder, other) { viewer ->
            viewer.board.state.graphs.single().lines shouldHaveSize 2
            viewer.panels.state.topics shouldBe false
            viewer.view.viewport.visible shouldBe other.span
        }
        started(home, folder, recordingOf(armBag(500), folder.resolve("other.bag"))) { it.board.state.graphs shouldHaveSize 1 }
        started(home, home.resolve("elsewhere"), one) { it.board.state shouldBe defaultBoard(one.view) }
    }

    test("the arrangement just before another log is shown is stored, and a new formula stays") {
        val home = tempdir().toPath()
        val one = recordingOf(armBag(500), home.resolve("one.bag"))
        val other = recordingOf(armBag(500), home.resolve("other.bag"))
        started(home, home, one) { it.panels.change { Panels(topics = false) } }
        hasArranged(home, home)?.graphs shouldBe null
        started(home, home, one) { viewer ->
            viewer.board.replace(Board().withGraph(listOf("Arm/Current", "Arm/Mode")))
            viewer.formulas.replaceAll(listOf("Twice = 2 * Arm/Current"))
            viewer.show(other)
            viewer.board.kept.graphs.map { it.lines } shouldBe listOf(listOf("Arm/Current", "Arm/Mode"))
        }
        hasArranged(home, home)?.graphs?.graphs?.map { it.lines } shouldBe listOf(listOf("Arm/Current", "Arm/Mode"))
        hasArranged(home, home)?.formulas shouldBe listOf("Twice = 2 * Arm/Current")
    }

    test("a recording that lacks signals does not make the others lose their graphs") {
        val home = tempdir().toPath()
        val whole = recordingOf(armBag(500), home.resolve("one.bag"))
        val poor = recordingOf(armBag(500).replace("Arm/Current", "Other"), home.resolve("poor.bag"))
        started(home, home, whole) { it.board.replace(Board().withGraph(listOf("Arm/Current", "Arm/Angle"))) }
        started(home, home, poor) { viewer ->
            viewer.board.state.graphs.single().lines shouldBe listOf("Arm/Angle")
            viewer.notices.all shouldHaveSize 1
            viewer.panels.change { Panels(library = false) }
        }
        started(home, home, whole) { it.board.state.graphs.single().lines shouldHaveSize 2 }
    }

    test("a graph of a formula is shown even if the log was read before the formulas of its folder were known") {
        val home = tempdir().toPath()
        val folder = Files.createDirectories(home.resolve("logs"))
        val log = Files.writeString(folder.resolve("one.bag"), armBag(500))
        started(home, folder, recordingOf(armBag(500), log)) {
            it.formulas.replaceAll(listOf("Arm/Twice = 2 * Arm/Angle"))
            it.board.replace(Board().withGraph(listOf("Arm/Twice")))
        }
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        onWindowThread {
            val following = listOf(launch { viewer.layouts.autosave() }, launch { viewer.shown.run() })
            viewer.library.change { LibraryState(folder) }
            awaitState { viewer.layouts.folder == folder }
            viewer.show(withContext(Dispatchers.IO) { OpenRecording.read(log, folder) })
            awaitState { viewer.board.state.graphs.singleOrNull()?.lines == listOf("Arm/Twice") && !viewer.shown.isWaiting }
            viewer.current.recording?.signal("Arm/Twice").shouldNotBeNull()
            viewer.notices.all shouldHaveSize 0
            following.forEach { it.cancel() }
        }
    }

    test("two windows over one folder keep each other's formulas") {
        val home = tempdir().toPath()
        val one = recordingOf(armBag(50), home.resolve("one.bag"))
        started(home, home, one) { viewer ->
            withContext(Dispatchers.IO) { FolderLayouts(home.resolve("layouts")).update(home) { Layout(Layout.VERSION, formulas = listOf("B = 2")) } }
            viewer.formulas.replaceAll(listOf("A = 1"))
        }
        hasArranged(home, home)?.formulas shouldBe listOf("A = 1", "B = 2")
        started(home, home, one) { viewer ->
            withContext(Dispatchers.IO) { FolderLayouts(home.resolve("layouts")).update(home) { Layout(Layout.VERSION, formulas = listOf("A = 3")) } }
            viewer.board.replace(Board().withGraph(listOf("Arm/Angle")))
        }
        hasArranged(home, home)?.formulas shouldBe listOf("A = 3")
    }

    test("two windows over one folder keep each other's graphs") {
        val home = tempdir().toPath()
        val one = recordingOf(armBag(50), home.resolve("one.bag"))
        val theirs = Board().withGraph(listOf("Arm/Current"))
        started(home, home, one) { viewer ->
            withContext(Dispatchers.IO) { FolderLayouts(home.resolve("layouts")).update(home) { Layout(Layout.VERSION, theirs) } }
            viewer.panels.change { Panels(topics = false) }
        }
        hasArranged(home, home)?.graphs shouldBe theirs
        hasArranged(home, home)?.panels?.topics shouldBe false
    }

    test("a layout for a type of match adds its formulas once, unless the graphs are arranged") {
        val home = tempdir().toPath()
        val folder = Files.createDirectories(home.resolve("logs"))
        val log = Files.writeString(folder.resolve("one.bag"), armBag(50).replace("Match Number", "Match Type").replace("\"8\"", "\"Practice\""))
        val layout = BoardLayout(Board().withGraph(listOf("Twice")), formulas = listOf("Twice = 2 * Arm/Angle", "Spare = 1"))
        Files.writeString(folder.resolve("practice.badlog-layout.json"), layout.toJson())
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        onWindowThread {
            val saving = launch { viewer.layouts.autosave() }
            viewer.library.change { LibraryState(folder) }
            awaitState { viewer.layouts.folder == folder }
            viewer.show(viewer.opened(log, folder))
            viewer.formulas.definitions shouldBe layout.formulas
            viewer.board.state.graphs.single().lines shouldBe listOf("Twice")
            viewer.formulas.remove("Spare = 1")
            viewer.show(viewer.opened(log, folder))
            viewer.formulas.definitions shouldBe listOf("Twice = 2 * Arm/Angle")
            viewer.board.replace(Board().withGraph(listOf("Arm/Angle")))
            viewer.layouts.saveNow()
            viewer.formulas.replaceAll(emptyList())
            saving.cancel()
        }
        val later = Viewer(MainScope(), UserFolders(home, home))
        onWindowThread {
            val saving = launch { later.layouts.autosave() }
            later.library.change { LibraryState(folder) }
            awaitState { later.layouts.folder == folder }
            later.formulas.replaceAll(emptyList())
            later.show(later.opened(log, folder))
            later.formulas.definitions shouldBe emptyList()
            saving.cancel()
        }
    }

    test("the last open log of a folder is known at the next start") {
        val home = tempdir().toPath()
        val one = recordingOf(armBag(50), home.resolve("one.bag"))
        started(home, home, one) { it.view.send(PlaceAction.Show(2.0, 3.0)) }
        suspend fun last() = Viewer(MainScope(), UserFolders(home, home)).layouts.lastOpenIn(home)
        last() shouldBe null
        Files.createFile(one.file)
        last()?.file shouldBe one.file
    }

    test("a damaged stored layout is ignored") {
        val home = tempdir().toPath()
        val one = recordingOf(armBag(50), home.resolve("one.bag"))
        started(home, home, one) { it.board.replace(Board().withGraph(listOf("Arm/Angle"))) }
        Files.list(home.resolve("layouts")).use { files -> files.forEach { Files.writeString(it, "{") } }
        started(home, home, one) { it.board.state shouldBe defaultBoard(one.view) }
    }
})
