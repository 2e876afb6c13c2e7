package badlog.viewer.panel.folder

import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.Tone
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.shown.folder.pitFacts
import badlog.viewer.shown.folder.verdictText
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction

/**
 * Returns the last log, batteries, the team's list and earlier logs, for a look between two matches.
 *
 * @param logs the logs; null if there are none.
 * @param emptiness the reason for that, as a sentence.
 * @param openBatteries shows the batteries; null if that is impossible.
 * @param todo the team's list, see [pitTodo]; null if there is none.
 * @param willRead returns whether a log is read without being opened.
 */
fun <E : ListedLog> pitPanel(
    logs: PitLogs<E>?,
    emptiness: String,
    advice: BatteryAdvice,
    openBatteries: Action? = null,
    todo: Card? = null,
    willRead: (E) -> Boolean = { true },
): List<Part> {
    val heading = Heading("Pit view", "")
    if (logs == null) return listOf(heading, Paragraph("empty", emptiness, Tone.TITLE))
    val batteries = advice.inPit.mapIndexed { i, each ->
        val severity = each.severity.takeIf { each !== advice.next }
        Card("battery $i", each.pitText, severity = severity, open = openBatteries, hint = "Show the batteries")
    }
    return listOf(
        heading,
        Paragraph("pit-title", logs.last.title, Tone.TITLE),
        Paragraph("pit-facts", pitFacts(logs.last), Tone.MUTED),
        lastLog(logs.last, willRead(logs.last)),
    ) + batteries + listOfNotNull(
        todo,
        Cards("pit-before", logs.before.map { earlierLog(it, willRead(it)) }).takeIf { it.cards.isNotEmpty() },
    )
}

private fun lastLog(log: ListedLog, isRead: Boolean): Card {
    val verdict = log.found?.verdict
    val next = verdict?.next.orEmpty()
    val unread = if (isUnread(log, isRead)) listOf("Open it to see what is in it.") else emptyList()
    val lines = unread + verdict?.sentences.orEmpty() + listOf("Next: $next").filter { next.isNotEmpty() }
    return cardOf(log, "", isRead, lines, isLarge = true)
}

private fun earlierLog(log: ListedLog, isRead: Boolean) = cardOf(log, log.title, isRead, emptyList(), isLarge = false)

private fun cardOf(log: ListedLog, title: String, isRead: Boolean, lines: List<String>, isLarge: Boolean) = Card(
    log.path,
    title,
    if (isUnread(log, isRead)) "Not read yet" else verdictText(log.found),
    lines,
    log.found?.verdict?.severity,
    isLarge,
    FolderAction.Open(log.path, showsFinding = true),
    "Show what was found in ${log.title}",
)

private fun isUnread(log: ListedLog, isRead: Boolean) = log.found == null && !isRead
