package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.battery.TeamBattery
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.panel.Trouble
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.batteryLog
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.FolderRequest
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class BatteriesPanelSpec : FunSpec({
    fun season(vararg uses: Pair<String?, Double>, team: List<TeamBattery> = emptyList()) = BatterySeason.of(
        uses.mapIndexed { i, (name, milliohms) -> batteryLog(i + 1, BatteryUse(name, "Battery", 8.5, 12.8, null, null, Resistance(milliohms, 0.4))) },
        team,
    )

    val seasons = season("B2" to 30.0, "B2" to 30.0, null to 21.0, "A1" to 20.0, "A1" to 20.2)

    fun panel(of: List<BatterySeason> = seasons, unfolded: Set<String> = emptySet()) = recordedBatteriesPanel(of, unfolded.associateWith { true }, emptyList(), isReading = false)

    fun List<Part>.rows() = filterIsInstance<Table>().single().rows
    fun TableRow.texts() = cells.map { cell -> cell.joinToString { it.text } }

    test("the advice is above the table, the battery to use next first") {
        val parts = panel()
        parts.filterIsInstance<Paragraph>().map { it.text } shouldBe listOf("Use A1 next", "Its resistance is 20.1 ± 0.3 mΩ and it is the only usable one.")
        parts.filterIsInstance<Trouble>().map { it.severity to it.text } shouldBe
            listOf(Severity.ERROR to "Retire B2. Its resistance is 30.0 ± 0.3 mΩ, 49 % more than that of A1 (20.1 ± 0.3 mΩ).")
        panel().rows().map { it.texts().run { first() to last() } } shouldBe listOf("A1" to "Use next", "B2" to "Retire", "Unknown" to "")
        panel(season("A1" to 20.0, team = listOf(TeamBattery("A1", isRetired = true)))).rows().single().texts().last() shouldBe "Retired"
    }

    test("a press on a battery shows its matches in the same columns, and one on a match opens its graphs") {
        val closed = panel().rows().first()
        closed.open.shouldBeInstanceOf<Action.Unfold>().run { fold to isOpen } shouldBe ("battery A1" to true)
        closed.cells.first().single().isUnfolded shouldBe false
        val rows = panel(unfolded = setOf("battery A1")).rows()
        rows.map { it.cells.first().single().text } shouldBe listOf("A1", "Qualification 5", "Qualification 4", "B2", "Unknown")
        rows[0].open.shouldBeInstanceOf<Action.Unfold>().isOpen shouldBe false
        rows[1].texts() shouldBe listOf("Qualification 5", "", "8.50 V", "20.2 ± 0.4 mΩ", "12.80 V", "Change…")
        rows[1].open.shouldBeInstanceOf<FolderAction.Open>().path shouldBe "/logs/q5.bag"
    }

    test("a battery without matches does not unfold") {
        val rows = panel(season("A1" to 20.0, team = listOf(TeamBattery("C3")))).rows()
        rows.last().run { open to cells.first().single().isUnfolded } shouldBe (null to null)
    }

    test("a person names the battery of a match, and chooses from the known names") {
        val ask = panel(unfolded = setOf("unknown")).rows().last().cells.last().single()
        ask.text shouldBe "Name…"
        val form = ask.open.shouldBeInstanceOf<Action.Ask>().request.shouldBeInstanceOf<FolderRequest.Fill>().form
        form.title shouldBe "Name the battery of Qualification 3"
        form.fields.single().run { text to suggestions } shouldBe ("" to listOf("A1", "B2"))
        form.isReady(listOf("")) shouldBe true
        val match = seasons.last().matches.single()
        form.actions(listOf(" C3 ")) shouldBe listOf(Action.Ask(FolderRequest.UseBattery(match, "C3")))
        batteriesPanel(seasons, mapOf("unknown" to true)).rows().last().texts().last() shouldBe ""
    }

    test("logs that name no battery get advice on naming them, and a folder without batteries says so") {
        panel(season(null to 20.0)).filterIsInstance<Paragraph>().single().text.substringBefore('.') shouldBe "No log says which battery was in the robot"
        fun only(isReading: Boolean) = recordedBatteriesPanel(emptyList(), emptyMap(), listOf("batteries.toml, line 1: …"), isReading).drop(1)
        only(isReading = false).run { (first() as Trouble).text to (last() as Paragraph).text } shouldBe
            ("batteries.toml, line 1: …" to "No log in this folder shows its battery.")
        (only(isReading = true).last() as Paragraph).text shouldBe "Reading the logs…"
    }
})
