package badlog.window.sidebar

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class PanelsSpec : FunSpec({
    test("a log that is opened in the list beside statistics across logs is shown; tables and charts of all logs stay") {
        Panels(main = MainView.STATISTICS, front = FrontPart.LOGS).showingLog() shouldBe Panels()
        for (view in listOf(MainView.LOGS, MainView.CHARTS)) Panels(main = view).showingLog() shouldBe Panels(main = view)
    }
})
