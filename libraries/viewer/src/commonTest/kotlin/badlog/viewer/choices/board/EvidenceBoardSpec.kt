package badlog.viewer.choices.board

import badlog.core.analysis.LogView
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.bagView
import badlog.viewer.draw.path.poseTopics
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith

class EvidenceBoardSpec : FunSpec({
    fun boardOf(view: LogView, names: List<String>) = evidenceBoard(view, names, SignalVocabulary.NONE)

    fun linesOf(view: LogView, vararg names: String) = boardOf(view, names.toList()).graphs.map { it.lines }

    val view = bagView(
        listOf("Time|xaxis", "A/Voltage", "B/Voltage", "Mode", "On", "Said|log", "Empty"),
        listOf("0,12,11,auto,true,hello,", "1,11,10,teleop,false,,"),
    )

    test("numbers of one unit share a graph, states another below") {
        linesOf(view, "Mode", "A/Voltage", "On", "B/Voltage") shouldBe listOf(listOf("A/Voltage", "B/Voltage"), listOf("Mode", "On"))
    }

    test("texts, topics without samples, repeated names and unknown topics are omitted") {
        linesOf(view, "Said", "Empty", "A/Voltage", "Nothing", "A/Voltage") shouldBe listOf(listOf("A/Voltage"))
        boardOf(view, listOf("Said")).graphs shouldBe emptyList()
    }

    test("any amount of evidence fits on a screen") {
        val names = (1..40).map { "Motors/Left $it" }
        val many = bagView(names, listOf(names.joinToString(",") { "1" }))
        boardOf(many, names).graphs.single().run {
            lines.size shouldBeLessThan 10
            checkNotNull(height) shouldBeLessThan 150
            title shouldBe "Motors: Left 1, Left 2…"
        }
    }

    test("a graph of several topics is named after them, in any folder") {
        boardOf(view, listOf("A/Voltage")).graphs.single().title shouldBe "A/Voltage"
        boardOf(view, listOf("A/Voltage", "B/Voltage")).graphs.single().title shouldEndWith "A/Voltage, B/Voltage"
    }

    test("poses are paths on the field, and their headings have a graph of their own") {
        val view = timedView(*(poseTopics("Pose") + poseTopics("Target Pose")).toTypedArray())
        val board = evidenceBoard(view, view.recording.topics.map { it.name }, SignalVocabulary.NONE)
        board.graphs.map { it.isXy to it.lines.size } shouldBe listOf(true to 4, false to 2)
        board.graphs.map { it.id } shouldBe listOf(1, 2)
    }
})
