package badlog.window.choice

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.state.PlaceAction
import badlog.window.bagOf
import badlog.window.compare.Comparison
import badlog.window.findings.findingsOf
import badlog.window.graph.choosing
import badlog.window.graph.viewerOf
import badlog.window.layout.Layout
import badlog.window.layout.LayoutSpan
import badlog.window.layout.readLayout
import badlog.window.layout.writeLayout
import badlog.window.log.OpenRecording
import badlog.window.log.RecordingChoices
import badlog.window.recordingOf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeSameInstanceAs
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicInteger

class ShownRecordingsSpec : FunSpec({
    fun log(name: String) = recordingOf(bagOf(listOf("Time", "Arm/Angle"), List(20) { "${10 + it * 0.5},$it" }), name)

    suspend fun <T> onWindow(action: () -> T): T = withContext(Dispatchers.Swing) { action() }

    test("logs and layouts are read, calculated, searched and written off the window's thread") {
        val file = Files.writeString(tempdir().toPath().resolve("a.bag"), bagOf(listOf("Time", "A"), listOf("0,1", "1,2")))
        val open = OpenRecording.read(file)
        val layout = file.resolveSibling("a${Layout.ENDING}")
        onWindow {
            for (work in listOf<() -> Any>(
                { OpenRecording.read(file) },
                { open.with(RecordingChoices(overTime = true)) },
                { findingsOf(open.forRules, file, null) },
                { readLayout(layout) },
                { writeLayout(layout, Layout(Layout.VERSION)) },
            )) {
                shouldThrow<AssertionError> { work() }.message shouldContain "the window’s thread"
            }
        }
    }

    test("a changed choice recalculates only the parts that depend on it") {
        val open = log("a.bag").with(RecordingChoices(definitions = listOf("Twice = 2 * Arm/Angle")))
        val otherField = open.with(open.choices.copy(fieldSelections = 1))
        otherField.view shouldBeSameInstanceAs open.view
        otherField.formulas shouldBeSameInstanceAs open.formulas
        val otherFormula = open.with(open.choices.copy(definitions = listOf("Half = Arm/Angle / 2")))
        otherFormula.logged shouldBeSameInstanceAs open.logged
        otherFormula.signal("Twice").shouldBeNull()
        otherFormula.signal("Half")?.series?.y?.last() shouldBe 9.5
        open.with(open.choices.copy(overTime = true)).signal("Twice")?.series?.x?.first() shouldBe 10.0
    }

    test("the calculation of formulas stops when their choice is replaced") {
        val wanted = RecordingChoices(definitions = List(100) { "F$it = $it * Arm/Angle" })
        var begun = 0
        shouldThrow<CancellationException> { log("a.bag").with(wanted) { if (++begun > 3) throw CancellationException() } }
        begun shouldBe 4

        val slow = SlowDefinitions(wanted.definitions)
        val viewer = viewerOf(log("a.bag"))
        val choices = RecordingChoices(slow)
        val shown = with(viewer) { ShownRecordings(current, compared, board, view, notices, { it() }, { null }) { choices } }
        onWindow { shown.isWaiting } shouldBe true
        withContext(Dispatchers.Swing) {
            val following = launch { shown.run() }
            withContext(Dispatchers.IO) { slow.awaitReader() }
            following.cancel()
            slow.goOn()
            following.join()
        }
        // A calculation that ends reads the definitions once more, with its results.
        slow.timesRead shouldBe 1
    }

    test("a choice is shown in the open log and the compared ones, and no calculation remains") {
        val open = log("a.bag")
        val other = log("b.bag")
        val viewer = viewerOf(open)
        viewer.compared.change { Comparison(checked = listOf(other.file), loaded = mapOf(other.file to other)) }
        choosing(viewer) {
            viewer.formulas.replaceAll(listOf("Twice = 2 * Arm/Angle"))
            viewer.axis.choose(true)
        }
        for (recording in viewer.compared.drawn.map { it.recording }) {
            recording.signal("Twice")?.series?.y?.last() shouldBe 38.0
            recording.span.from shouldBe 10.0
        }
        viewer.view.viewport.full.from shouldBe 10.0
        viewer.shown.isWaiting shouldBe false
    }

    test("the last of several choices in a row counts") {
        val viewer = viewerOf(log("a.bag"))
        choosing(viewer) {
            for (number in 1..20) {
                viewer.formulas.replaceAll(listOf("Times = $number * Arm/Angle"))
                viewer.axis.choose(number % 2 == 0)
            }
        }
        viewer.current.recording?.signal("Times")?.series?.y?.last() shouldBe 20 * 19.0
        viewer.current.recording?.span?.from shouldBe 10.0
    }

    test("arranged graphs stay, and so does the visible range unless the axis changes") {
        val viewer = viewerOf(log("a.bag"))
        val own = Board().withGraph(listOf("Arm/Angle"))
        viewer.board.replace(own)
        viewer.view.send(PlaceAction.Show(2.0, 4.0))
        choosing(viewer) { viewer.formulas.replaceAll(listOf("Twice = 2 * Arm/Angle")) }
        viewer.board.state shouldBe own
        viewer.view.viewport.visible.from shouldBe 2.0
        choosing(viewer) { viewer.axis.choose(true) }
        viewer.view.viewport.isZoomed shouldBe false
    }

    test("a missing field file is reported, and the path is drawn without it") {
        val log = Files.copy(Path.of("..", "samples", "wrong-turn.bag"), tempdir().toPath().resolve("a.bag"))
        val gone = log.resolveSibling("gone.json")
        val viewer = viewerOf(OpenRecording.read(log))
        choosing(viewer) { viewer.settings.change { withField("${log.parent}", "$gone") } }
        viewer.notices.all.single().text shouldContain "gone.json"
        viewer.current.recording?.fieldPicture.shouldBeNull()
    }

    test("an action that waits for a shown choice runs after it, or at once if no choice is waiting") {
        val viewer = viewerOf(log("a.bag"))
        val seen = ArrayList<Double>()
        val note = { seen += checkNotNull(viewer.current.recording).span.from }
        viewer.shown.afterShown { note() }
        choosing(viewer) {
            viewer.axis.choose(true)
            viewer.shown.afterShown { note() }
        }
        seen shouldBe listOf(0.0, 10.0)
    }

    test("a layout applies its axis and its range, but not to another log opened meanwhile") {
        val viewer = viewerOf(log("a.bag"))
        val layout = Layout(Layout.VERSION, visible = LayoutSpan(12.0, 14.0), overTime = true)
        choosing(viewer) { viewer.layouts.apply(layout) }
        viewer.view.viewport.visible shouldBe Span(12.0, 14.0)

        val other = log("b.bag").with(RecordingChoices(overTime = true))
        val own = Board().withGraph(listOf("Arm/Angle"))
        choosing(viewer) {
            viewer.axis.choose(false)
            viewer.layouts.apply(layout.copy(graphs = Board().withGraph(listOf("Time"))))
            viewer.current.replace(other)
            viewer.board.replace(own)
            viewer.view.send(PlaceAction.Open(other.span))
        }
        viewer.board.state shouldBe own
        viewer.view.viewport.isZoomed shouldBe false
    }

    test("a grown log keeps its choices and visible range; over another axis, all of it is shown") {
        val viewer = viewerOf(log("a.bag"))
        viewer.view.send(PlaceAction.Show(2.0, 4.0))
        viewer.shown.show(log("a.bag"))
        viewer.view.viewport.visible shouldBe Span(2.0, 4.0)
        viewer.shown.show(log("a.bag").with(RecordingChoices(overTime = true)))
        viewer.view.viewport.visible shouldBe Span(10.0, 19.5)
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("Arm/Angle"))
    }
})

/** Definitions of formulas, with a reader that waits until [goOn] is called. */
private class SlowDefinitions(private val all: List<String>) : AbstractList<String>() {
    private val isRead = CountDownLatch(1)
    private val mayGoOn = CountDownLatch(1)
    private val lastReads = AtomicInteger()

    /** The number of times that the last definition was read. */
    val timesRead: Int get() = lastReads.get()

    override val size: Int get() = all.size

    override fun get(index: Int): String {
        isRead.countDown()
        check(mayGoOn.await(60, TimeUnit.SECONDS)) { "Nobody lets the reader go on." }
        if (index == all.lastIndex) lastReads.incrementAndGet()
        return all[index]
    }

    fun awaitReader() = check(isRead.await(60, TimeUnit.SECONDS)) { "Nobody reads the definitions." }

    fun goOn() = mayGoOn.countDown()
}
