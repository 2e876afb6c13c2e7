package badlog.signals.match

import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MatchOfLogSpec : FunSpec({
    fun of(values: List<Value>, name: String): MatchOfLog {
        val recording = Recording(RecordingFormat.BAG, null, values, emptyList(), 0, emptyList())
        return RuleSet.BUILT_IN.signals.matchOf(recording, name)
    }

    test("values show event, type, number and alliance") {
        val values = listOf(
            Value("FMS/Event_Name", "OHCL"),
            Value("Match Type", "Qualification"),
            Value("MATCH NUMBER", "42"),
            Value("Alliance Station", "Red2"),
        )
        of(values, "any.bag") shouldBe MatchOfLog("OHCL", "Qualification", "42", "Red")
    }

    test("the size of a record that is not decoded is not the number of a match") {
        fun match(type: String): MatchOfLog {
            val counts = CellCounts(1, 0, 0, 0, 0, 0)
            val name = "NT:/FMSInfo/MatchNumber"
            val topic = Topic(name, if (type == "double") "ul" else "B", emptyList(), doubleArrayOf(8.0), TextColumn.EMPTY, counts, doubleArrayOf(0.0), type)
            return RuleSet.BUILT_IN.signals.matchOf(Recording(RecordingFormat.CSV, null, emptyList(), listOf(topic), 0, emptyList()), "a.wpilog")
        }
        match("msgpack") shouldBe MatchOfLog()
        match("double") shouldBe MatchOfLog(number = "8")
    }

    test("the driver station's values without a field are ignored") {
        val values = listOf(Value("Event Name", " "), Value("Match Type", "None"), Value("Match Number", "0"))
        of(values, "practice.bag") shouldBe MatchOfLog()
    }

    test("a type in the name is not combined with a number in the values") {
        of(listOf(Value("Match Number", "5")), "q7.bag") shouldBe MatchOfLog(number = "5")
    }

    test("a log without metadata is of the match that its name shows") {
        of(emptyList(), "FRC_20240316_104107_MILLC_Q42.wpilog") shouldBe MatchOfLog("MILLC", "Qualification", "42")
        of(listOf(Value("Event Name", "OHCL")), "Q42.wpilog") shouldBe MatchOfLog("OHCL", "Qualification", "42")
    }

    test("the kind of run follows from the type, under any of its names") {
        val types = mapOf(
            MatchKind.MATCH to listOf("Qualification", "quals", "QUAL", "Quarterfinal", "Semifinal", "Elimination", "Elims", "playoff", "Final"),
            MatchKind.PRACTICE to listOf("Practice", "practice match", "Test"),
            MatchKind.UNKNOWN to listOf("Demonstration", "3", null),
        )
        for ((kind, texts) in types) for (text in texts) withClue(text) { MatchOfLog(type = text).kind shouldBe kind }
    }

    test("an alliance that is neither red nor blue is as logged") {
        of(listOf(Value("Alliance", "Green")), "any.bag").alliance shouldBe "Green"
    }
})
