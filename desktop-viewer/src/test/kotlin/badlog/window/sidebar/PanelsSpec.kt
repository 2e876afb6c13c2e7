package badlog.window.sidebar

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class PanelsSpec : FunSpec({
    test("a log that is opened in the list beside statistics across logs is shown; tables and charts of all logs stay") {
        Panels(main = MainView.STATISTICS, front = FrontPart.LOGS).showingLog() shouldBe Panels()
        for (view in listOf(MainView.LOGS, MainView.CHARTS)) Panels(main = view).showingLog() shouldBe Panels(main = view)
    }

    test("in a small window, the topics give way to the panel on the right, unless a person opened them beside it") {
        Panels().inspecting(InspectorTab.FINDINGS).run {
            showsTopics(isRoomy = true) shouldBe true
            showsTopics(isRoomy = false) shouldBe false
            withTopics().showsTopics(isRoomy = false) shouldBe true
            withTopics().inspecting(InspectorTab.NOTES).showsTopics(isRoomy = false) shouldBe true
            withTopics().withoutInspector().inspecting(InspectorTab.FINDINGS).showsTopics(isRoomy = false) shouldBe false
            withoutInspector().showsTopics(isRoomy = false) shouldBe true
        }
    }
})
