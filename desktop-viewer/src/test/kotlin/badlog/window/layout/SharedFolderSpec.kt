package badlog.window.layout

import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.window.app.Viewer
import badlog.window.change
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.folder.LibraryState
import badlog.window.log.OpenRecording
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.cancelAndJoin
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.time.Duration.Companion.seconds

/** Several windows that use the layout of one folder. */
@Tags("InCheck")
class SharedFolderSpec : FunSpec({
    val home = tempdir().toPath()
    val folders = generateSequence(0) { it + 1 }.map { Files.createDirectories(home.resolve("logs $it")) }.iterator()
    val layouts = FolderLayouts(home.resolve("layouts"))

    fun arm(folder: Path, name: String = "one.bag", change: (String) -> String = { it }): OpenRecording = recordingOf(change(armBag(50)), folder.resolve(name))

    /** Opens a window on [folder], which finally shows [recording]; [before] runs before the folder is known. */
    fun window(folder: Path, recording: OpenRecording = arm(folder), before: Viewer.() -> Unit = {}): Viewer = runBlocking(Dispatchers.Swing) {
        val viewer = Viewer(MainScope(), UserFolders(home, home)).apply(before)
        withContext(Dispatchers.IO) { layouts.update(folder) { (it ?: Layout(Layout.VERSION)).copy(panels = LayoutPanels(topics = false)) } }
        viewer.library.change { LibraryState(folder) }
        val saving = launch { viewer.layouts.autosave() }
        eventually(60.seconds) { viewer.panels.state.topics shouldBe false }
        saving.cancelAndJoin()
        if (viewer.current.recording == null) viewer.show(recording)
        viewer
    }

    fun stored(folder: Path): List<String> = layouts.read(folder)?.graphs?.graphs.orEmpty().map { it.title }

    fun arranged(vararg lines: String) = lines.fold(Board()) { board, line -> board.withGraph(listOf(line)) }

    fun Viewer.id(title: String) = board.arranged.graphs.single { it.title == title }.id

    test("a formula that one window removes is stored in no graph, whatever another window that still has it changes") {
        val folder = folders.next()
        val twice = "Twice = 2 * Arm/Angle"
        layouts.update(folder) { Layout(Layout.VERSION, arranged("Arm/Angle", "Twice", "Arm/Current"), formulas = listOf(twice)) }
        val a = window(folder, arm(folder, "poor.bag") { it.replace("Arm/Angle", "Wrist/Angle") })
        val b = window(folder)
        b.board.change { resized(b.id("Twice"), 200).withGraph(listOf("Twice", "Arm/Mode")) }
        b.layouts.saveNow()
        a.formulas.remove(twice) shouldBe true
        a.board.undo()
        a.layouts.saveNow()
        b.board.change { withGraph(listOf("Twice")) }
        b.layouts.saveNow()
        layouts.read(folder)?.formulas shouldBe emptyList()
        layouts.read(folder)?.graphs?.graphs.orEmpty().map { it.lines } shouldBe listOf(listOf("Arm/Angle"), listOf("Arm/Current"), listOf("Arm/Mode"))
    }

    test("graphs arranged before the folder is known count as a change of the log's initial graphs") {
        val folder = folders.next()
        layouts.update(folder) { Layout(Layout.VERSION, arranged("Arm/Angle")) }
        val viewer = window(folder) {
            show(arm(folder))
            board.change { withGraph(listOf("Arm/Current", "Arm/Mode")) }
        }
        viewer.layouts.saveNow()
        layouts.read(folder)?.graphs?.graphs?.map { it.lines } shouldBe listOf(listOf("Arm/Current", "Arm/Mode"), listOf("Arm/Angle"))
    }

    test("graphs arranged for a folder survive changes while a young log has few or no lines of them") {
        for (before in listOf(arranged("Arm/Angle", "Arm/Mode"), arranged("Arm/Angle", "Arm/Current", "Arm/Mode"))) {
            val folder = folders.next()
            layouts.update(folder) { Layout(Layout.VERSION, before) }
            val viewer = window(folder, arm(folder, "young.bag") { it.replace("Arm/Angle", "Young/Angle").replace("Arm/Mode", "Young/Mode") })
            viewer.board.state.graphs.flatMap { it.lines } shouldContain "Arm/Current"
            viewer.board.change { withGraph(listOf("Arm/Current")) }
            viewer.board.change { moved(graphs.last().id, -1) }
            viewer.layouts.saveNow()
            viewer.shown.show(arm(folder, "young.bag"))
            val lines = viewer.board.state.graphs.flatMap { it.lines }
            lines.toSet() shouldBe setOf("Arm/Angle", "Arm/Current", "Arm/Mode")
            lines.count { it == "Arm/Current" } shouldBe 2
            window(folder).board.arranged shouldBe viewer.board.arranged
        }
    }

    test("a window reads the layout of its folder off its thread, and has saved the last change before it closes") {
        val folder = folders.next()
        val log = Files.writeString(folder.resolve("one.bag"), armBag(50))
        layouts.update(folder) { Layout(Layout.VERSION, arranged("Arm/Angle"), recording = "one.bag") }
        val viewer = window(folder)
        withContext(Dispatchers.Swing) {
            viewer.layouts.lastOpenIn(folder)?.file shouldBe log
            viewer.board.change { withGraph(listOf("Arm/Current")) }
            viewer.layouts.saveNow()
        }
        stored(folder) shouldBe listOf("Arm/Angle", "Arm/Current")
    }

    test("two windows that save at the same moment keep each other's changes") {
        val folder = folders.next()
        val windows = List(2) { window(folder) }
        val moment = CyclicBarrier(windows.size)
        fun formula(window: Int, number: Int) = "F$window$number = $number"
        val threads = windows.mapIndexed { at, viewer ->
            thread {
                for (number in 1..30) {
                    viewer.formulas.replaceAll(viewer.formulas.definitions + formula(at, number))
                    moment.await(1, TimeUnit.MINUTES)
                    viewer.layouts.saveNow()
                }
            }
        }
        threads.forEach { it.join() }
        layouts.read(folder)?.formulas.orEmpty() shouldContainExactlyInAnyOrder (1..30).flatMap { listOf(formula(0, it), formula(1, it)) }
    }
})
