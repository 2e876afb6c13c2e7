package badlog.viewer.choices.board

import badlog.viewer.bagView
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class DefaultBoardSpec : FunSpec({
    val setting = timedTopic("Gain", 0.0 to 1.0, 4.0 to 1.0)

    test("topics of a WPILOG that never change or were never logged are not drawn at first") {
        val view = timedView(setting, timedTopic("Nothing"), timedTopic("Voltage", 0.0 to 12.0, 4.0 to 11.0))
        defaultBoard(view).graphs.map { it.lines } shouldBe listOf(listOf("Voltage"))
    }

    test("if nothing changes at all, everything is drawn") {
        defaultBoard(timedView(setting)).graphs.size shouldBe 1
    }

    test("consecutive states of a folder share a graph, with a lane for each") {
        val view = bagView(listOf("Time|xaxis", "A/Mode", "A/On", "A/Angle", "Gear"), listOf("0,auto,true,1,LOW", "1,teleop,false,2,HIGH"))
        defaultBoard(view).graphs.map { it.title to it.lines } shouldBe listOf(
            "Gear" to listOf("Gear"),
            "A/States" to listOf("A/Mode", "A/On"),
            "A/Angle" to listOf("A/Angle"),
        )
    }
})
