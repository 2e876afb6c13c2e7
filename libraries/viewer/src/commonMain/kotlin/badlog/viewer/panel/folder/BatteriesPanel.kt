package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Column
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.panel.Tone
import badlog.viewer.panel.Trouble
import badlog.viewer.shown.battery.AdvisedBattery
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatteryColumn
import badlog.viewer.shown.battery.BatteryMatch
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.BatteryStep
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.FolderRequest
import badlog.viewer.state.Form
import badlog.viewer.state.FormField

/**
 * Returns the team's batteries with advice; each unfolds to its matches.
 *
 * @param unfolded the batteries that a person has unfolded, by the keys of their rows.
 * @param rename returns the action that asks for the battery of a match; null if the shell cannot record it.
 */
fun batteriesPanel(
    seasons: List<BatterySeason>,
    unfolded: Map<String, Boolean>,
    rename: ((BatteryMatch, BatterySeason) -> Action)? = null,
): List<Part> {
    val advice = BatteryAdvice.of(seasons)
    val next = advice.next
    val others = (advice.retire + advice.charge).mapIndexed { i, each -> Trouble("advice $i", each.severity, each.text) }
    return listOfNotNull(
        Heading("Batteries", ""),
        next?.let { Paragraph("next", it.headline, Tone.TITLE) },
        next?.let { Paragraph("reason", it.reason, Tone.MUTED) },
    ) + others + SeasonTable(seasons, advice, unfolded, rename).all()
}

/**
 * Returns the same for a shell that reads and writes the team's files about batteries.
 *
 * @param problems the reasons why such a file is not used, as sentences.
 * @param isReading whether logs are still being read.
 */
fun recordedBatteriesPanel(
    seasons: List<BatterySeason>,
    unfolded: Map<String, Boolean>,
    problems: List<String>,
    isReading: Boolean,
): List<Part> {
    val all = batteriesPanel(seasons, unfolded) { match, season -> renameBattery(match, season, seasons) }
    val lack = when {
        seasons.any { it.battery != null } -> null
        seasons.isNotEmpty() -> UNNAMED
        isReading -> "Reading the logs…"
        else -> "No log in this folder shows its battery."
    }
    val troubles = problems.mapIndexed { i, text -> Trouble("problem $i", Severity.WARNING, text) }
    val notes = troubles + listOfNotNull(lack?.let { Paragraph("lack", it, Tone.MUTED) })
    return all.take(1) + notes + if (seasons.isEmpty()) emptyList() else all.drop(1)
}

/** Asks for the name of the battery of [match], which is one of [season] so far, and offers the names in [all]. */
private fun renameBattery(match: BatteryMatch, season: BatterySeason, all: List<BatterySeason>): Action {
    val field = FormField(NAME, season.battery?.name.orEmpty(), suggestions = all.mapNotNull { it.battery?.name })
    val form = Form("Name the battery of ${match.title}", listOf(field), "Name") { (name) ->
        if (name == field.text) emptyList() else listOf(Action.Ask(FolderRequest.UseBattery(match, name)))
    }
    return Action.Ask(FolderRequest.Fill(form))
}

/** The severity of the advice; the battery to use next is good news. */
internal val AdvisedBattery.severity: Severity
    get() = when (step) {
        BatteryStep.USE -> Severity.NOTE
        BatteryStep.RETIRE -> Severity.ERROR
        BatteryStep.CHECK -> Severity.WARNING
    }

private class SeasonTable(
    private val seasons: List<BatterySeason>,
    private val advice: BatteryAdvice,
    private val unfolded: Map<String, Boolean>,
    private val rename: ((BatteryMatch, BatterySeason) -> Action)?,
) {
    private val columns = BatteryColumn.of(seasons)

    fun all(): Table {
        val titles = columns.map { Column(it.title, it.meaning, isNumber = it.isNumber, key = it.name.lowercase()) }
        val rows = seasons.flatMap { season ->
            val isOpen = unfolded[season.key] == true
            listOf(rowOf(season, isOpen)) + if (isOpen) season.matches.map { rowOf(it, season) } else emptyList()
        }
        return Table("seasons", titles + Column("Advice", key = "advice"), listOf(RowGroup(rows)), "Batteries")
    }

    private fun rowOf(season: BatterySeason, isOpen: Boolean): TableRow {
        val advised = advice.of(season)
        val label = if (season.battery?.isRetired == true) "Retired" else advised?.step?.label
        val toggle = if (season.matches.isEmpty()) null else Action.Unfold(season.key, !isOpen)
        val title = Cell(
            season.title,
            hint = if (isOpen) "Hide its matches" else "Show its matches",
            open = toggle,
            isUnfolded = toggle?.let { isOpen },
        )
        val cells = columns.map { if (it == BatteryColumn.BATTERY) title else Cell(it.text(season).orEmpty()) }
        return entry(season.key, "Battery ${season.title}", cells + Cell(label.orEmpty(), advised?.reason ?: label.orEmpty()), toggle)
    }

    /** Returns a row for [match] in the columns of its battery. */
    private fun rowOf(match: BatteryMatch, season: BatterySeason): TableRow {
        val own = BatterySeason(null, listOf(match))
        val path = match.paths.first()
        val open = FolderAction.Open(path, showsFinding = false)
        val cells = columns.map {
            when (it) {
                BatteryColumn.BATTERY -> Cell(match.title, hint = "Show the graphs of ${match.title}", open = open)
                BatteryColumn.MATCHES -> Cell("")
                else -> Cell(it.text(own).orEmpty())
            }
        }
        val ask = rename?.let { Cell(if (season.battery == null) "Name…" else "Change…", open = it(match, season)) }
        return entry("${season.key}\n$path", match.title, cells + (ask ?: Cell("")), open, isMuted = true)
    }

    private fun entry(key: String, name: String, cells: List<Cell>, open: Action?, isMuted: Boolean = false) =
        TableRow(name, cells.map { cell -> listOf(cell).filter { it.text.isNotEmpty() } }, key, open = open, isMuted = isMuted)
}

private const val NAME = "Name of the battery; leave it empty to use the name in the log"
private const val UNNAMED = "No log says which battery was in the robot. Open the list below and press “Name…” beside each match, or let " +
    "the robot log a value “Battery Name”."
