package badlog.signals.match

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class MatchInNameSpec : FunSpec({
    listOf(
        "qualification-42.bag" to MatchOfLog(type = "Qualification", number = "42"),
        "Q7.badbag" to MatchOfLog(type = "Qualification", number = "7"),
        "qm012.csv" to MatchOfLog(type = "Qualification", number = "12"),
        "match_3.bag.gz" to MatchOfLog(number = "3"),
        "ohcl_sf2m1.bag" to MatchOfLog(type = "Semifinal", number = "2-1"),
        "final 2.bag" to MatchOfLog(type = "Final", number = "2"),
        "FRC_20240316_104107_MILLC_Q42.wpilog" to MatchOfLog("MILLC", "Qualification", "42"),
        "akit_24-03-16_10-41-07_ohcl_e5.bag" to MatchOfLog("ohcl", "Elimination", "5"),
        "MIKET_Q12_rio_20180316.bag" to MatchOfLog("MIKET", "Qualification", "12"),
        "MIKET_Q12_rio_2018-03-16_10-41-07.bag" to MatchOfLog("MIKET", "Qualification", "12"),
        "OHCL QF 1.bag" to MatchOfLog("OHCL", "Quarterfinal", "1"),
        "2018ohcl_qm12.bag" to MatchOfLog("ohcl", "Qualification", "12"),
        "FRC_OHCL_Q3.wpilog" to MatchOfLog("OHCL", "Qualification", "3"),
        "LOG_Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "RED ALLIANCE Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "RED_Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "BLUE_Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "RED2_Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "TEAM254_Q3.bag" to MatchOfLog(type = "Qualification", number = "3"),
        "COMP_Q12.bag" to MatchOfLog(type = "Qualification", number = "12"),
        "PRACTICE_Q1.bag" to MatchOfLog(type = "Qualification", number = "1"),
        "FRC_20240316_104107_RED_Q3.wpilog" to MatchOfLog(type = "Qualification", number = "3"),
        "REDDING_Q3.bag" to MatchOfLog("REDDING", "Qualification", "3"),
        "Q9_2024-03-16.bag" to MatchOfLog(type = "Qualification", number = "9"),
        "FRC_20240910_002949.bag" to MatchOfLog(),
        "elevator-bench.csv" to MatchOfLog(),
        "motif12.bag" to MatchOfLog(),
        "" to MatchOfLog(),
    ).forEach { (name, facts) ->
        test("the name “$name” shows ${facts.match ?: "no match"}") { matchInName(name) shouldBe facts }
    }

    test("digits that are not the number of a match are ignored") {
        checkAll(Arb.string(0, 40)) { name -> matchInName(name).number?.length?.let { (it <= 6) shouldBe true } }
    }
})
