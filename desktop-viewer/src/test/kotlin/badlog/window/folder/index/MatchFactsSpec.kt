package badlog.window.folder.index

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Value
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.vocabulary.matchOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MatchFactsSpec : FunSpec({
    fun named(name: String) = MatchFacts.of(emptyList(), name, logged = null)

    fun of(values: List<Value>, name: String): MatchFacts {
        val recording = Recording(RecordingFormat.BAG, null, values, emptyList(), 0, emptyList())
        return MatchFacts.of(values, name, RuleSet.BUILT_IN.signals.matchOf(recording))
    }

    test("values show event, type, number and alliance") {
        val values = listOf(
            Value("FMS/Event_Name", "OHCL"),
            Value("Match Type", "Qualification"),
            Value("MATCH NUMBER", "42"),
            Value("Alliance Station", "Red2"),
        )
        of(values, "any.bag") shouldBe MatchFacts("OHCL", "Qualification", "42", "Red")
    }

    test("what the driver station gives without a field means nothing") {
        val values = listOf(Value("Event Name", " "), Value("Match Type", "None"), Value("Match Number", "0"))
        of(values, "practice.bag") shouldBe MatchFacts()
    }

    listOf(
        "qualification-42.bag" to MatchFacts(type = "Qualification", number = "42"),
        "Q7.badbag" to MatchFacts(type = "Qualification", number = "7"),
        "qm012.csv" to MatchFacts(type = "Qualification", number = "12"),
        "match_3.bag.gz" to MatchFacts(number = "3"),
        "ohcl_sf2m1.bag" to MatchFacts(type = "Semifinal", number = "2-1"),
        "final 2.bag" to MatchFacts(type = "Final", number = "2"),
        "FRC_20240316_104107_MILLC_Q42.wpilog" to MatchFacts("MILLC", "Qualification", "42"),
        "akit_24-03-16_10-41-07_ohcl_e5.bag" to MatchFacts("ohcl", "Elimination", "5"),
        "Q9_2024-03-16.bag" to MatchFacts(type = "Qualification", number = "9"),
        "FRC_20240910_002949.bag" to MatchFacts(),
        "elevator-bench.csv" to MatchFacts(),
        "motif12.bag" to MatchFacts(),
        "" to MatchFacts(),
    ).forEach { (name, facts) ->
        test("the name “$name” shows ${facts.match ?: "no match"}") { named(name) shouldBe facts }
    }

    test("a type in the name is not put to a number of the values") {
        of(listOf(Value("Match Number", "5")), "q7.bag") shouldBe MatchFacts(number = "5")
    }
})
