package badlog.window.findings

import badlog.rules.RulesFile
import badlog.viewer.shown.finding.RuleResults
import badlog.window.bagOf
import badlog.window.log.OpenRecording
import badlog.window.recordingOf
import java.nio.file.Files
import java.nio.file.Path

/** Returns a rule in the form of a file. */
internal fun ruleText(name: String, condition: String, severity: String = "warning", text: String = "$name at {time}"): String = "[[rule]]\nname = \"$name\"\nseverity = \"$severity\"\nwhen = \"$condition\"\ntext = \"$text\"\n"

/** Writes [rules] as the rules of [folder]. */
internal fun writeRules(folder: Path, vararg rules: String): Path = Files.writeString(Files.createDirectories(folder).resolve(RulesFile.NAME), rules.joinToString("\n"))

/** Returns a recording in [folder] of a hundred rows, one each second. `A` counts them, `B` is 1 in every tenth. */
internal fun counted(folder: Path, rows: Int = 100): OpenRecording = recordingOf(
    bagOf(listOf("Time|xaxis", "A", "B"), List(rows) { "$it,$it,${if (it % 10 == 0) 1 else 0}" }),
    folder.resolve("counted.bag").toString(),
)

/** Returns the findings of the folder's rules in [recording]. */
internal fun findingsIn(recording: OpenRecording): RuleResults = findingsOf(recording.view, recording.file, library = null)
