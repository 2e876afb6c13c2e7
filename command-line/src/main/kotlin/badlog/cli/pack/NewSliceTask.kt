package badlog.cli.pack

import badlog.cli.command.ExitCode
import badlog.cli.command.LogLoop
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.input.Failure
import badlog.cli.input.FileName
import badlog.cli.output.writeLog
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.wrapped
import badlog.files.safeName
import badlog.files.terminal.Progress
import badlog.rules.pack.PackException
import badlog.rules.pack.RulePack
import kotlinx.serialization.Serializable
import java.nio.file.Files
import java.nio.file.Path

/** Cuts the slice for [order] into the pack [pack], which is created if it does not exist. Adds the rule if it is new. */
internal class NewSliceTask(private val pack: Path, private val order: SliceOrder, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode = try {
        val made = console.progress("${order.log.fileName}").use(::make)
        if (isJson) console.say(Spelling.ascii("${jsonOf(NewSliceJson(order, made))}")) else console.say(text(made, console.width))
        ExitCode.WHOLE
    } catch (e: PackException) {
        console.warn(e.message)
        ExitCode.USAGE
    } catch (e: Exception) {
        console.warn(LogLoop.sentenceOf(e, order.log))
        ExitCode.NOTHING
    }

    /**
     * A new slice, with the verdict on it.
     *
     * @property file the slice.
     * @property condition the condition of the rule; null if there was one before.
     * @property verdict the verdict of the rule on the slice.
     */
    internal class NewSlice(val file: Path, val cut: SliceCut, val condition: String?, val verdict: SliceVerdict)

    private fun make(progress: Progress): NewSlice {
        if (Files.isRegularFile(pack)) throw Failure("$pack is a zip; unpack it, and name its folder.")
        val rules = PackRules(pack)
        val isNew = !rules.has(order.rule)
        if (isNew && order.isSilent) {
            throw Failure(
                "There is no rule “${order.rule}” in $pack that could be silent; begin without --silent, with a moment that it must find.",
            )
        }
        val isConditionTaken = !isNew && order.condition != null
        if (isConditionTaken) {
            throw Failure("The rule “${order.rule}” has a condition already; leave out --when, or change it in the pack.")
        }
        val cut = SliceCut(order, progress)
        val condition = if (isNew) cut.condition() else null
        val kind = if (order.isSilent) RulePack.SILENT else RulePack.FIRES
        val folder = pack.resolve(kind).resolve(SliceCheck.folderOf(order.rule))
        val wanted = FileName.of(Path.of(safeName(cut.nameFrom(FileName.of(order.log).stem)) + cut.format.ending)).fitting()
        val file = folder.resolve(wanted.free { !Files.exists(folder.resolve(it)) })
        writeLog(cut.recording, cut.format, file, progress = progress)
        rules.add(order.rule, condition)
        val verdict = RulePack.open(pack).use { opened ->
            val name = listOf(kind, folder.fileName, file.fileName).joinToString("/")
            SliceCheck(opened).verdict(opened.slices.single { it.name == name })
        }
        return NewSlice(file, cut, condition, verdict)
    }

    private fun text(made: NewSlice, width: Int): String {
        val removed = made.cut.removed.map { (kind, count) -> counted(count.toLong(), kind.noun, kind.nouns) }
        val lines = listOfNotNull(
            "kept ${made.cut.place}",
            if (removed.isEmpty()) "nothing private found: no team number, address, user or path" else "removed ${removed.joinToString()}",
            made.condition?.let { "began the rule “${order.rule}”: $it" },
            (if (made.verdict.passes) "the rule agrees: " else "the rule does not agree yet; change it in the pack: ") + made.verdict.text,
        )
        return "${order.log} -> ${made.file}\n" + lines.joinToString("\n") { wrapped("  ", it, INDENT, width) }
    }
}

@Serializable
private class NewSliceJson private constructor(
    private val command: String,
    private val file: String,
    private val status: String,
    private val output: String,
    private val rule: String,
    private val condition: String?,
    private val part: String,
    private val removed: Map<String, Int>,
    private val passes: Boolean,
    private val text: String,
) {
    constructor(order: SliceOrder, made: NewSliceTask.NewSlice) : this(
        command = "rules",
        file = "${order.log}",
        status = "whole",
        output = "${made.file}",
        rule = order.rule,
        condition = made.condition,
        part = made.cut.place,
        removed = made.cut.removed.mapKeys { (kind, _) -> kind.name.lowercase() },
        passes = made.verdict.passes,
        text = made.verdict.text,
    )
}

private const val INDENT = 4
