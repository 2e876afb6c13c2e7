package badlog.window.topics

import badlog.window.bagOf
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe

class TopicRowsSpec : FunSpec({
    fun signalsOf(vararg names: String) = recordingOf(bagOf(listOf("Time|xaxis") + names, listOf("0," + names.joinToString(",") { "1" }))).signals

    fun text(rows: List<TopicRow>) = rows.map { row ->
        "  ".repeat(row.depth) + when (row) {
            is FolderRow -> "${row.title}/ ${row.count}"
            is GraphRow -> row.graph.title
            is SignalRow -> row.signal.title
        }
    }

    val signals = signalsOf("arm/Wrist/Angle", "Mode", "Arm/Angle", "Drive/Left", "Arm/Wrist/Speed")

    test("folders list their topics, then their folders, regardless of case") {
        text(topicRows(signals, "", emptySet())) shouldContainExactly listOf(
            "Mode", "Arm/ 2", "  Angle", "  Wrist/ 1", "    Speed", "arm/ 1", "  Wrist/ 1", "    Angle", "Drive/ 1", "  Left",
        )
    }

    test("a closed folder hides its content, and a search opens it") {
        text(topicRows(signals, "", setOf("Arm", "arm"))) shouldContainExactly
            listOf("Mode", "Arm/ 2", "arm/ 1", "Drive/ 1", "  Left")
        text(topicRows(signals, "DRIVE le", setOf("Drive"))) shouldContainExactly listOf("Drive/ 1", "  Left")
    }

    test("folders of a large log begin closed, and stay as a person left them; folders of a small log begin open") {
        val small = TopicList().listing(foldersOf(signals))
        small.folded shouldBe emptySet()
        val large = signalsOf(*Array(30) { "Module $it/Inner//Speed" }, "Arm/Angle")
        foldersOf(large).size shouldBe 61
        val list = small.listing(foldersOf(large))
        text(topicRows(large, "", list.folded)).take(3) shouldContainExactly listOf("Arm/ 1", "  Angle", "Module 0/ 1")
        list.folded.size shouldBe 60
        val opened = list.toggledFolder("Module 0")
        opened.listing(foldersOf(large)).folded shouldBe opened.folded
    }

    test("a search for one topic over another offers their XY plot, if it can have a graph of its own") {
        val numbers = recordingOf(bagOf(listOf("Time|xaxis", "Arm/Volts", "Arm/Amps", "Mode"), listOf("0,1,2,auto", "1,2,3,auto"))).signals
        text(topicRows(numbers, "volts over amps", emptySet(), offersXy = true)) shouldContainExactly listOf("Arm/Volts over Arm/Amps")
        text(topicRows(numbers, "arm over mode", emptySet(), offersXy = true)) shouldBe emptyList()
        text(topicRows(numbers, "volts over amps", emptySet())) shouldBe emptyList()
    }

    test("each word must be in the name or its folders") {
        topicRows(signals, "wrist angle", emptySet()).filterIsInstance<SignalRow>().map { it.signal.name } shouldContainExactly
            listOf("arm/Wrist/Angle")
        topicRows(signals, "nothing", emptySet()) shouldBe emptyList()
    }

    test("10,000 topics are all listed, each line with its own key") {
        val many = signalsOf(*Array(10_000) { "Folder ${it % 100}/Topic $it" })
        val rows = topicRows(many, "", emptySet())
        rows.size shouldBe 10_100
        rows.map { it.key }.toSet().size shouldBe rows.size
        rows.filterIsInstance<FolderRow>().map { it.title.lowercase() }.shouldBeSorted()
    }

    test("a selection up to a row takes all rows between, in either direction") {
        val rows = topicRows(signals, "", emptySet())
        val list = TopicList().toggled("Arm/Angle").selectedTo("arm/Wrist/Angle", rows)
        list.selected shouldContainExactly listOf("Arm/Angle", "Arm/Wrist/Speed", "arm/Wrist/Angle")
        TopicList().toggled("Arm/Angle").selectedTo("Mode", rows).selected shouldContainExactly listOf("Arm/Angle", "Mode")
        TopicList().selectedTo("Mode", rows).selected shouldContainExactly listOf("Mode")
    }

    test("a folder has its own topics and its subfolders' topics, not the topics of a folder with a longer name") {
        val more = signalsOf("Arm/Angle", "Arm/Wrist/Speed", "Arm 2/Angle", "Mode", "/Drive//Left")
        topicsIn("Arm", more).map { it.name } shouldContainExactly listOf("Arm/Angle", "Arm/Wrist/Speed")
        topicsIn("Arm/Wrist", more).map { it.name } shouldContainExactly listOf("Arm/Wrist/Speed")
        topicsIn("Drive", more).map { it.name } shouldContainExactly listOf("/Drive//Left")
    }
})
