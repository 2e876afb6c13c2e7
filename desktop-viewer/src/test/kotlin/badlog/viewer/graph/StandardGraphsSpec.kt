package badlog.viewer.graph

import badlog.viewer.loggedTexts
import badlog.viewer.loggedTopic
import badlog.viewer.wpilogRecording
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class StandardGraphsSpec : FunSpec({
    val setting = loggedTopic("Gain", 0.0 to 1.0, 4.0 to 1.0)
    val voltage = loggedTopic("Voltage", 0.0 to 12.0, 4.0 to 11.0)

    test("of a WPILOG, what never changes or was never logged is not drawn at first") {
        val open = wpilogRecording(
            setting,
            loggedTopic("Nothing"),
            voltage,
            loggedTexts("title", 0.0 to "a"),
            loggedTexts("mode", 0.0 to "a", 1.0 to "b"),
        )
        standardGraphs(open.view).graphs.map { graph -> graph.lines.map { it.signal } } shouldBe listOf(listOf("Voltage"), listOf("mode"))
        overviewSpec(open)!!.lines.single().signal shouldBe "Voltage"
    }

    test("where nothing changes at all, all is drawn") {
        standardGraphs(wpilogRecording(setting).view).graphs.size shouldBe 1
    }
})
