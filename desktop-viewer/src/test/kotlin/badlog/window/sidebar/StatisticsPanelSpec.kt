package badlog.window.sidebar

import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.panel.NamedSpan
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.findings.counted
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import kotlinx.coroutines.MainScope

class StatisticsPanelSpec : FunSpec({
    test("statistics are calculated again for another range, selection or signal, never because the cursor moves") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val open = counted(home)
        fun asked() = statisticsInput(viewer.compared, viewer.board, viewer.view, open)
        viewer.show(open)
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
})
