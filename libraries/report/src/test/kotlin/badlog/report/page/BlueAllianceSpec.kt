package badlog.report.page

import badlog.signals.match.MatchOfLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class BlueAllianceSpec : FunSpec({
    test("a match leads to its page, or without a certain number to the page of its event") {
        fun path(event: String?, type: String?, number: String?, year: Int? = 2018) = blueAllianceOf(MatchOfLog(event, type, number), year)?.removePrefix("https://www.thebluealliance.com/")
        path("ONWAT", "Qualification", "12") shouldBe "match/2018onwat_qm12"
        path("MIKET", "Quarterfinal", "2-1") shouldBe "match/2018miket_qf2m1"
        path("MIKET", "Semifinal", "2-3") shouldBe "match/2018miket_sf2m3"
        path("MIKET", "Final", "2") shouldBe "match/2018miket_f1m2"
        path("MIKET", "Final", "1-2") shouldBe "match/2018miket_f1m2"
        path("GALILEO", "Qualification", "28", 2022) shouldBe "match/2022gal_qm28"
        path("MIKET", "Semifinal", "11", 2024) shouldBe "match/2024miket_sf11m1"
        // Before double elimination, one number did not name a single match.
        path("MIKET", "Semifinal", "3", 2022) shouldBe "event/2022miket"
        path("MIKET", "Elimination", "3") shouldBe "event/2018miket"
        path("MIKET", "Qualification", "12 replay") shouldBe "event/2018miket"
        path("MIKET", "Qualification", null) shouldBe "event/2018miket"
    }

    test("practice, an event that is not a code, and an unknown year have no link") {
        for ((event, type) in listOf("MIKET" to "Practice", "MIKET" to null, "Mill Creek Regional" to "Qualification", "Home" to "Qualification", null to "Final")) {
            blueAllianceOf(MatchOfLog(event, type, "1"), 2024) shouldBe null
        }
        blueAllianceOf(MatchOfLog("MIKET", "Qualification", "1"), null) shouldBe null
    }
})
