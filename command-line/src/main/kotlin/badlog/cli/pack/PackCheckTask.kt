package badlog.cli.pack

import badlog.cli.command.ExitCode
import badlog.cli.command.Task
import badlog.cli.console.Console
import badlog.cli.console.Spelling
import badlog.cli.text.counted
import badlog.cli.text.jsonOf
import badlog.cli.text.wrapped
import badlog.rules.pack.PackException
import badlog.rules.pack.RulePack
import kotlinx.serialization.Serializable
import java.nio.file.Path

/** Runs the rules of the pack [path] over its slices. Lists the rules without a slice in which they must fire, or be silent. */
internal class PackCheckTask(private val path: Path, private val isJson: Boolean) : Task {
    override fun run(console: Console): ExitCode = try {
        RulePack.open(path).use { check(it, console) }
    } catch (e: PackException) {
        console.warn(e.message)
        ExitCode.USAGE
    }

    private fun check(pack: RulePack, console: Console): ExitCode {
        val check = SliceCheck(pack)
        val verdicts = pack.slices.map { slice -> check.verdict(slice).also { say(it, console) } }
        val lacking = pack.rules.rules.flatMap { rule ->
            val own = pack.slices.filter { check.isFor(it, rule.name) }
            listOf(true, false).filter { isFiring -> own.none { it.isFiring == isFiring } }.map { MissingSlice(rule.name, it) }
        }
        if (isJson) console.say(summaryJson(pack, verdicts, lacking)) else console.say(summary(pack, verdicts, lacking, console.width))
        return when {
            verdicts.any { it.isMistake } -> ExitCode.USAGE
            verdicts.none { it.passes } -> ExitCode.NOTHING
            verdicts.any { !it.passes } -> ExitCode.SALVAGED
            else -> ExitCode.WHOLE
        }
    }

    private fun say(verdict: SliceVerdict, console: Console) {
        if (isJson) {
            console.say(json(SliceJson(verdict)))
        } else {
            val first = (if (verdict.passes) "ok" else "failed").padEnd(STATUS_WIDTH)
            val text = "${verdict.slice.name}: ${verdict.text}"
            // A mistake in a rule is shown with its line, and carets below it.
            val lines = text.lines()
            val rest = lines.drop(1).map { " ".repeat(STATUS_WIDTH) + it }
            console.say((listOf(wrapped(first, lines.first(), width = console.width)) + rest).joinToString("\n"))
        }
    }

    private fun summary(pack: RulePack, verdicts: List<SliceVerdict>, lacking: List<MissingSlice>, width: Int): String {
        val passed = verdicts.count { it.passes }
        val counts = listOf(counted(pack.rules.rules.size.toLong(), "rule"), counted(verdicts.size.toLong(), "slice"))
        val devices = pack.rules.devices.devices.size.toLong()
        val all = (counts + listOfNotNull(counted(devices, "device").takeIf { devices > 0 })).joinToString()
        val failed = verdicts.size - passed
        val result = "$passed pass${if (passed == 1) "es" else ""}, $failed fail${if (failed == 1) "s" else ""}"
        val head = "$all: ${if (failed == 0) "all slices pass" else result}."
        val lines = (if (verdicts.isEmpty()) "$all: no slice shows what the rules find." else head).let(::listOf) +
            lacking.map { "“${it.rule}” has no slice in which it must ${it.must}; add one with badlog rules new." } +
            pack.ignored.map { "“$it” is not part of a pack, and is ignored." }
        return lines.joinToString("\n") { wrapped("", it, INDENT, width) }
    }

    private fun summaryJson(pack: RulePack, verdicts: List<SliceVerdict>, lacking: List<MissingSlice>) = json(
        PackJson(
            command = "rules",
            file = "$path",
            status = if (verdicts.any { !it.passes }) "failed" else "whole",
            rules = pack.rules.rules.map { it.name },
            slices = verdicts.size,
            failed = verdicts.count { !it.passes },
            devices = pack.rules.devices.devices.size,
            lacking = lacking.map { MissingSliceJson(it.rule, folderOf(it.isFiring)) },
            ignored = pack.ignored,
        ),
    )

    private inline fun <reified T> json(value: T) = Spelling.ascii("${jsonOf(value)}")

    /** A rule without a slice in which it must fire, or must not. */
    private class MissingSlice(val rule: String, val isFiring: Boolean) {
        val must get() = if (isFiring) "find something" else "stay silent"
    }
}

private fun folderOf(isFiring: Boolean) = if (isFiring) RulePack.FIRES else RulePack.SILENT

@Serializable
private class SliceJson private constructor(
    private val command: String,
    private val file: String,
    private val status: String,
    private val kind: String,
    private val rule: String?,
    private val text: String,
) {
    constructor(verdict: SliceVerdict) : this(
        "rules",
        verdict.slice.name,
        if (verdict.passes) "whole" else "failed",
        folderOf(verdict.slice.isFiring),
        verdict.rule,
        verdict.text,
    )
}

@Serializable
private class PackJson(
    private val command: String,
    private val file: String,
    private val status: String,
    private val rules: List<String>,
    private val slices: Int,
    private val failed: Int,
    private val devices: Int,
    private val lacking: List<MissingSliceJson>,
    private val ignored: List<String>,
)

@Serializable
private class MissingSliceJson(private val rule: String, private val kind: String)

private const val STATUS_WIDTH = 8
private const val INDENT = 2
