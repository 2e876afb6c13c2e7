package badlog.report

import badlog.files.inFolder
import badlog.report.page.reportPage
import badlog.viewer.shown.battery.BatterySeason
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path
import kotlin.math.sin

/** Puts the log of qualification [match] into this folder, with a [battery] of [milliohms]. */
private fun Path.putMatch(match: Int, battery: String?, milliohms: Double, name: String = "q$match.bag") {
    val rows = (0..1000).map { i ->
        val amps = if (i < 50) 2.0 else 60 + 50 * sin(i / 3.0)
        "${i / 10.0},${i >= 50},${12.8 - amps * milliohms / 1000},$amps"
    }
    val values = mapOf("Match Type" to "Qualification", "Match Number" to "$match", "Start Time" to "2026-03-14T10:${10 + match}:00") +
        listOfNotNull(battery?.let { "Battery Name" to it })
    put(name, bag(mapOf("Time" to "s", "Enabled" to "ul", "Battery Voltage" to "V", "Total Current" to "A"), rows, values))
}

class SeasonOfLogsSpec : FunSpec({
    fun overFolder(folder: Path, cache: Path? = null) = SeasonOfLogs.over(logsIn(folder), listOf(folder), cache)

    fun titles(seasons: List<BatterySeason>) = seasons.associate { season -> season.title to season.matches.map { it.title } }

    test("the batteries are those that the logs name, and the file beside them or above") {
        inFolder { folder ->
            folder.resolve("a").putMatch(1, "A1", 20.0)
            folder.resolve("b").putMatch(2, null, 20.0)
            folder.resolve("b").putMatch(3, "B2", 20.0)
            folder.resolve("b").putMatch(4, null, 20.0)
            folder.put("batteries.toml", "[[battery]]\nname = \"C3\"\n[used]\n\"Qualification 2\" = \"A1\"\n\"b/q3.bag\" = \"A1\"\n")
            val season = overFolder(folder)
            titles(season.seasons) shouldBe mapOf(
                "A1" to listOf("Qualification 3", "Qualification 2", "Qualification 1"),
                "C3" to emptyList(),
                "Unknown" to listOf("Qualification 4"),
            )
            titles(Report().over(logsIn(folder)).batteries.seasons) shouldBe titles(season.seasons)
        }
    }

    test("a file with a mistake is not used, and reported") {
        inFolder { folder ->
            folder.putMatch(1, "A1", 20.0)
            folder.put("batteries.toml", "battery = 1")
            val season = overFolder(folder)
            titles(season.seasons).keys shouldBe setOf("A1")
            season.problems.single() shouldContain "batteries.toml is not used: "
        }
    }

    test("a log with cached results is not read again") {
        inFolder { cache ->
            inFolder { folder ->
                folder.putMatch(1, "A1", 20.0)
                val first = overFolder(folder, cache).seasons.single().resistance
                spoil(folder.resolve("q1.bag"))
                overFolder(folder, cache).seasons.single().resistance shouldBe first
                overFolder(folder).entries.single().isReadable shouldBe false
            }
        }
    }

    test("text, CSV and the page of a report have the batteries, with advice") {
        inFolder { folder ->
            for (match in listOf(1, 3, 5)) folder.putMatch(match, "A1", 20.0)
            for (match in listOf(2, 4)) folder.putMatch(match, "=B2<i>", 30.0)
            val seasons = overFolder(folder).seasons
            val text = batteryText(seasons).lines()
            text[0].split(Regex(" {2,}")) shouldContainExactly
                listOf("Battery", "Matches", "Lowest", "Resistance", "Rest before", "Energy")
            text[1] shouldContain "30.0 ± 0.1 mΩ"
            text.filter { it.startsWith("Retire") }.single() shouldBe
                "Retire =B2<i>. Its resistance is 30.0 ± 0.1 mΩ, 50 % more than that of A1 (20.0 ± 0.1 mΩ)."
            batteryCsv(seasons).lines()[1].split(',').take(2) shouldBe listOf("'=B2<i>", "2")
            val page = reportPage(Report().over(logsIn(folder)))
            page shouldContain "<h2>Batteries</h2>"
            page shouldContain "<b>Use A1 next.</b> Its resistance is 20.0 ± 0.1 mΩ and it is the only usable one."
            page shouldNotContain "<i>"
        }
    }

    test("a report of logs that name no battery has no part about them") {
        inFolder { folder ->
            folder.putMatch(1, null, 20.0)
            reportPage(Report().over(logsIn(folder))) shouldNotContain "Batteries"
        }
    }
})
