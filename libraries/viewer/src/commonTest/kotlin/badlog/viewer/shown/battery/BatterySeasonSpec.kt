package badlog.viewer.shown.battery

import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.battery.TeamBattery
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.shown.folder.AnyLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

/** A log of qualification [match], an hour after the one before. */
internal fun batteryLog(match: Int, use: BatteryUse?, file: String = "q$match.bag", content: Content = Content.SOMETHING) = AnyLog(
    "/logs/$file",
    LogSummary(MatchOfLog(type = "Qualification", number = "$match"), LogDate(1_700_000_000L + 7200 * match, DateSource.VALUES), content = content, battery = use),
    null,
)

class BatterySeasonSpec : FunSpec({
    fun use(name: String?, milliohms: Double? = null, lowest: Double? = 8.0, rest: Double? = null) = BatteryUse(name, "Battery", lowest, rest, null, null, milliohms?.let { Resistance(it, 0.5) })

    fun texts(season: BatterySeason) = BatteryColumn.entries.mapNotNull { it.text(season) }

    test("batteries are in the order of their names, then the retired ones, then the unknown one") {
        val logs = listOf(batteryLog(1, use("B10")), batteryLog(2, use("B2")), batteryLog(3, use(null)), batteryLog(4, use("A1")))
        val team = listOf(TeamBattery("A1", isRetired = true), TeamBattery("C"))
        BatterySeason.of(logs, team).map { it.title } shouldContainExactly listOf("B2", "B10", "C", "A1", "Unknown")
    }

    test("the team's notes count more than the log") {
        val seasons = BatterySeason.of(listOf(batteryLog(1, use("B2"))), usedFor = { "A1" })
        seasons.map { it.title } shouldContainExactly listOf("A1")
    }

    test("a battery has one row, however its name is written, and one called Unknown is not the unknown one") {
        val seasons = BatterySeason.of(listOf(batteryLog(1, use("a1")), batteryLog(2, use("A1")), batteryLog(3, use("Unknown")), batteryLog(4, use(null))))
        seasons.map { it.matches.size } shouldContainExactly listOf(2, 1, 1)
        seasons.map { it.key }.distinct().size shouldBe 3
    }

    test("logs of robot and Driver Station are one match, and idle logs do not count") {
        val robot = batteryLog(1, use("A1", lowest = null), "robot.bag")
        val station = batteryLog(1, use(null, 20.0, lowest = 7.256), "station.dslog")
        val seasons = BatterySeason.of(listOf(robot, station, batteryLog(2, use("A1"), content = Content.NOTHING_CHANGES)))
        texts(seasons.single()) shouldContainExactly listOf("A1", "1", "7.25 V", "20.0 ± 0.5 mΩ")
    }

    test("a log and its copy are one match") {
        fun practice(file: String) = AnyLog("/logs/$file", LogSummary(MatchOfLog(), LogDate(1_700_000_000L, DateSource.VALUES), content = Content.SOMETHING, battery = use("A1", 20.0)), null)
        BatterySeason.of(listOf(practice("a.wpilog"), practice("copies/a.wpilog"))).single().matches.size shouldBe 1
    }

    test("the resistance grows if later matches certainly have more than earlier ones") {
        fun seasonOf(vararg milliohms: Double) = BatterySeason.of(milliohms.mapIndexed { i, each -> batteryLog(i, use("A1", each)) }).single()
        BatteryColumn.GROWTH.text(seasonOf(20.0, 20.2, 22.0, 22.2)) shouldBe "+2.0 ± 0.5 mΩ"
        seasonOf(20.0, 20.2, 20.1, 20.3).growth.shouldBeNull()
        seasonOf(22.0, 22.2, 20.0, 20.1).growth.shouldBeNull()
        seasonOf(20.0, 25.0).growth.shouldBeNull()
    }

    test("the age is the age at the last match") {
        val logs = listOf(batteryLog(1, use("A1")), batteryLog(2, use("B2")))
        val seasons = BatterySeason.of(logs, listOf(TeamBattery("A1", "2023-01"), TeamBattery("B2", "2020"), TeamBattery("C", "2025")))
        seasons.map { BatteryColumn.AGE.text(it) } shouldContainExactly listOf("10 months", "3 years", null)
    }

    test("only columns with a text are in the table") {
        BatteryColumn.of(BatterySeason.of(listOf(batteryLog(1, use("A1"))))) shouldContainExactly
            listOf(BatteryColumn.BATTERY, BatteryColumn.MATCHES, BatteryColumn.LOWEST)
        BatterySeason.of(listOf(batteryLog(1, null))).shouldBeEmpty()
    }
})
