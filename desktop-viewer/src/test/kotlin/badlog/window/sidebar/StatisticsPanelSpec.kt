package badlog.window.sidebar

import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.compare.DrawnRecording
import badlog.window.findings.counted
import badlog.window.graph.sample
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import kotlinx.coroutines.MainScope

class StatisticsPanelSpec : FunSpec({
    test("statistics are calculated again for another range, selection or signal, never because the cursor moves") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        fun asked() = statisticsInput(viewer.compared, viewer.board, viewer.view)
        viewer.show(counted(home))
        val before = asked()
        for (x in listOf(3.0, 4.0)) {
            viewer.view.send(PlaceAction.MoveCursor(x))
            asked() shouldBe before
        }
        viewer.view.send(PlaceAction.Show(10.0, 20.0))
        val zoomed = asked()
        zoomed shouldNotBe before
        viewer.view.send(PlaceAction.Select(Span(12.0, 13.0)))
        asked().part shouldBe NamedSpan("Selection", Span(12.0, 13.0))
        viewer.view.send(PlaceAction.Select(null))
        asked() shouldBe zoomed
        for (x in listOf(15.0, 12.0)) viewer.view.send(PlaceAction.Click(x, reach = 0.1, isShifted = x == 12.0))
        asked().part shouldBe NamedSpan(Cursors.BETWEEN, Span(12.0, 15.0))
    }

    test("statistics are of the visible range, of the time enabled, or of the whole log") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val open = sample("qualification-42.bag")
        viewer.show(open)
        viewer.view.send(PlaceAction.Show(10.0, 20.0))
        spanOf(StatisticsRange.SHOWN, open, viewer.view) shouldBe NamedSpan("Visible range", Span(10.0, 20.0))
        spanOf(StatisticsRange.ALL, open, viewer.view)?.span shouldBe open.span
        val enabled = spanOf(StatisticsRange.ENABLED, open, viewer.view).shouldNotBeNull().span
        enabled.from shouldBe open.enabled.first().span.from
        enabled.to shouldBe open.enabled.last().span.to
        val parts = spanOf(StatisticsRange.ENABLED, open, viewer.view).shouldNotBeNull()
        parts.parts.size shouldBe 2
        parts.width shouldBeLessThan enabled.width - 1
        val cells = rangeStatistics(listOf(DrawnRecording(open)), listOf("System/Enabled"), parts).signals.single().cells
        cells.map { it.name } shouldBe listOf("first", "last", "samples", "in true")
        for (x in listOf(15.0, 12.0)) viewer.view.send(PlaceAction.Click(x, reach = 0.1, isShifted = x == 12.0))
        titleOfShown(viewer.view) shouldBe "A–B"
        repeat(3) { viewer.view.send(PlaceAction.Cancel) }
        val never = counted(home)
        spanOf(StatisticsRange.ENABLED, never, viewer.view) shouldBe null
        statisticsInput(viewer.compared, viewer.board, viewer.view, null).part.name shouldBe "Visible range"
    }
})
