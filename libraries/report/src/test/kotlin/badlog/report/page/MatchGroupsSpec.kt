package badlog.report.page

import badlog.files.inFolder
import badlog.report.Report
import badlog.report.bag
import badlog.report.logsIn
import badlog.report.put
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path

private fun Path.match(name: String, event: String?, type: String?, number: String?, start: String? = null) {
    val values = mapOf("Event Name" to event, "Match Type" to type, "Match Number" to number, "Start Time" to start)
    put("$name.bag", bag(mapOf("Time" to "s"), listOf("0", "1"), values.mapNotNull { (key, value) -> value?.let { key to it } }.toMap()))
}

private fun groupsIn(folder: Path): List<Pair<String, List<String>>> {
    val logs = Report(RuleSet.NONE).over(logsIn(folder)).logs.mapIndexed { i, log -> IndexedLog(i, log, log.file.name, null, "") }
    return groupsOf(logs).map { group -> group.title to group.logs.map { it.file.removeSuffix(".bag") } }
}

class MatchGroupsSpec : FunSpec({
    test("logs are in the order of events, of types of matches, and of matches") {
        inFolder { folder ->
            folder.match("f", "MIKET", "Final", "1", "2018-03-17 16:00:00 UTC")
            folder.match("q10", "MIKET", "Qualification", "10", "2018-03-17 12:00:00 UTC")
            folder.match("q9", "MIKET", "Qualification", "9")
            folder.match("sf", "miket", "Semifinal", "2-1")
            folder.match("qf", "MIKET", "Quarterfinal", "3-1")
            folder.match("p", "MIKET", "Practice", "2", "2018-03-16 12:00:00 UTC")
            folder.match("later", "ABCD", "Qualification", "1", "2018-04-01 12:00:00 UTC")
            folder.match("shop", null, null, null, "2018-01-01 12:00:00 UTC")
            groupsIn(folder) shouldBe listOf(
                "MIKET 2018 · Practice" to listOf("p"),
                "MIKET 2018 · Qualification" to listOf("q9", "q10"),
                "MIKET 2018 · Quarterfinal" to listOf("qf"),
                "MIKET 2018 · Semifinal" to listOf("sf"),
                "MIKET 2018 · Final" to listOf("f"),
                "ABCD 2018 · Qualification" to listOf("later"),
                "No event · Other" to listOf("shop"),
            )
        }
    }

    test("an event of two years is two events") {
        inFolder { folder ->
            for (year in 2018..2019) folder.match("$year", "MIKET", "Qualification", "1", "$year-03-17 12:00:00 UTC")
            folder.match("unknown", "MIKET", "Qualification", "2")
            groupsIn(folder).map { it.first } shouldBe
                listOf("MIKET 2018 · Qualification", "MIKET 2019 · Qualification", "MIKET · Qualification")
        }
    }

    test("the page offers the order by event if there is more than one group, and leads to The Blue Alliance") {
        inFolder { folder ->
            folder.match("a/q1", "MIKET", "Qualification", "1", "2018-03-17 12:00:00 UTC")
            folder.match("b/p1", "MIKET", "Practice", "1", "2018-03-16 12:00:00 UTC")
            val page = reportPage(Report(RuleSet.NONE).over(logsIn(folder)))
            page shouldContain "<option value=\"event\">By event and match</option>"
            page shouldContain "MIKET 2018 · Practice"
            page.split("https://www.thebluealliance.com/match/2018miket_qm1\"").size shouldBe 2
            reportPage(Report(RuleSet.NONE).over(logsIn(folder.resolve("a")))) shouldNotContain "By event"
        }
    }
})
