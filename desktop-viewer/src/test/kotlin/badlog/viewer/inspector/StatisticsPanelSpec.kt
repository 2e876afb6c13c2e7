package badlog.viewer.inspector

import badlog.analysis.Span
import badlog.viewer.app.Viewer
import badlog.viewer.findings.counted
import badlog.viewer.settings.UserFolders
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import kotlinx.coroutines.MainScope

class StatisticsPanelSpec : FunSpec({
    test("statistics are calculated again for another range, selection or signal, never because the cursor moves") {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        fun asked() = askedFor(viewer.compared, viewer.board, viewer.view)
        viewer.show(counted(home))
        val before = asked()
        for (x in listOf(3.0, 4.0, null)) {
            viewer.view.placeCursor(x)
            asked() shouldBe before
        }
        viewer.view.change { showing(10.0, 20.0) }
        val zoomed = asked()
        zoomed shouldNotBe before
        viewer.view.select(Span(12.0, 13.0))
        asked().span shouldBe Span(12.0, 13.0)
        asked().isSelection shouldBe true
        viewer.view.select(null)
        asked() shouldBe zoomed
    }
})
