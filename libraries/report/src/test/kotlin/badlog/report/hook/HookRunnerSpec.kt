package badlog.report.hook

import badlog.core.python.HAS_PYTHON
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.core.waiting.eventually
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogFormat
import badlog.report.ROOT
import badlog.report.sample
import badlog.rules.commandWords
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldStartWith
import java.io.File
import java.io.IOException
import java.nio.file.Files
import kotlin.time.Duration
import kotlin.time.Duration.Companion.minutes
import kotlin.time.Duration.Companion.seconds

private val RECORDING: Recording by lazy { readRecording(sample("qualification-42.bag"), LOG_FORMATS) }

private val HAS_R: Boolean = try {
    ProcessBuilder("Rscript", "-e", "library(jsonlite)").start().waitFor() == 0
} catch (_: IOException) {
    false
}

private val IS_WINDOWS = System.getProperty("os.name").startsWith("Windows")

private fun isRunning(process: String): Boolean = ProcessHandle.of(process.toLong()).filter { it.isAlive }.isPresent

/** Runs a [program] in Python, for which the time stands still unless [nanos] says otherwise. */
private fun python(program: String, limit: Duration = 5.minutes, nanos: () -> Long = { 0 }): HookResult = HookRunner(listOf("python3", "-c", program, "{header}"), limit, "hook", null, nanos).run(RECORDING)

@Tags("InCheck")
class HookRunnerSpec : FunSpec({
    test("the example prints the output in docs/hooks.md").config(enabled = HAS_PYTHON) {
        val hook = HookRunner(commandWords("python3 '${File(ROOT, "docs/hooks/analyze.py")}' {header}"), 5.minutes)
        val result = hook.run(RECORDING)
        val lines = result.values.map { (name, text) -> "$name: $text" } +
            result.findings.map { "${it.severity.name.lowercase()} at ${it.time}: ${it.text}" } +
            result.series.map { "series “${it.name}” in ${it.unit}, ${it.data.size} samples" } +
            result.figures.map { "figure “${it.title}”, ${it.mediaType}" }
        File(ROOT, "docs/hooks.md").readText() shouldContain "```hook\n${lines.joinToString("\n")}\n```"
    }

    test("the example in R returns values and a picture").config(enabled = HAS_R) {
        val result = HookRunner(commandWords("Rscript '${File(ROOT, "docs/hooks/analyze.R")}'"), 5.minutes).run(RECORDING)
        result.values["Deviation of Drivetrain/Angle"] shouldBe "587.3"
        result.figures.single().mediaType shouldBe "image/png"
    }

    test("the line of R's output with the error is reported").config(enabled = HAS_PYTHON) {
        val failure = shouldThrow<HookException> { python("import sys; sys.exit('Error: no such column\\nExecution halted\\n')") }
        failure.message shouldBe "The hook ended with exit code 1; its last error: Error: no such column."
    }

    test("a hook gets all rows, and the header's path twice").config(enabled = HAS_PYTHON) {
        val result = python(
            """
            import json, os, sys
            lines = sys.stdin.read().splitlines()
            header = json.load(open(sys.argv[1], encoding='utf-8'))
            print(json.dumps({'values': {'rows': len(lines) - 1, 'topics': len(header['topics']),
                'same': str(sys.argv[1] == os.environ['BADLOG_HEADER']), 'path': sys.argv[1]}}))
            """.trimIndent(),
        )
        result.values["rows"] shouldBe RECORDING.rowCount.toString()
        result.values["topics"] shouldBe RECORDING.topics.size.toString()
        result.values["same"] shouldBe "True"
        File(result.values.getValue("path")).exists() shouldBe false
    }

    test("a log without rows is given in rows of 20 ms").config(enabled = HAS_PYTHON) {
        val counts = CellCounts(2, 0, 0, 0, 0, 0)
        val topic = Topic("volts", "V", emptyList(), doubleArrayOf(12.0, 6.0), TextColumn.EMPTY, counts, doubleArrayOf(0.0, 0.05))
        val recording = Recording(WpilogFormat, null, emptyList(), listOf(topic), 0, emptyList())
        val program = "import json, sys; print(json.dumps({'values': {'csv': sys.stdin.read().strip()}}))"
        HookRunner(listOf("python3", "-c", program), 5.minutes).run(recording).values.getValue("csv").lines() shouldBe
            listOf("Time,volts", "0,12", "0.02,12", "0.04,12", "0.06,6")
    }

    test("a hook runs in its folder").config(enabled = HAS_PYTHON) {
        val folder = Files.createTempDirectory("badlog-hook").toRealPath()
        val program = "import json, os; print(json.dumps({'values': {'folder': os.getcwd()}}))"
        HookRunner(listOf("python3", "-c", program), 5.minutes, folder = folder).run(RECORDING).values["folder"] shouldBe folder.toString()
        Files.delete(folder)
    }

    test("a hook need not read its input").config(enabled = HAS_PYTHON) {
        python("print('{}')").findings.shouldBeEmpty()
    }

    test("a hook that fails is reported with its last error").config(enabled = HAS_PYTHON) {
        val failure = shouldThrow<HookException> { python("import sys; sys.exit('no such column')") }
        failure.message shouldBe "The hook ended with exit code 1; its last error: no such column."
    }

    test("the last error is also reported if a hook prints nothing").config(enabled = HAS_PYTHON) {
        shouldThrow<HookException> { python("import sys; print('odd column', file=sys.stderr)") }.message shouldBe
            "The hook printed nothing; it must print one JSON object, at least {}. Its last error: odd column."
    }

    test("a file that is not a program is reported as such").config(enabled = !IS_WINDOWS) {
        val file = File.createTempFile("hook", ".py")
        try {
            shouldThrow<HookException> { HookRunner(listOf("$file"), 1.seconds).run(RECORDING) }.message shouldBe
                "The file “$file” cannot be run as a program (Permission denied); name the program that runs it, as in “python3 $file”, " +
                "or make it executable with chmod +x."
        } finally {
            file.delete()
        }
    }

    test("a hook ends, and its header is deleted, when the program gets a signal to end").config(enabled = HAS_PYTHON && !IS_WINDOWS) {
        val report = File.createTempFile("hook", ".txt")
        try {
            val program = """
                import os, subprocess, sys, time
                child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(3600)'])
                open(r'$report', 'w').write('%d %d %s .' % (os.getpid(), child.pid, os.environ['BADLOG_HEADER']))
                time.sleep(3600)
            """.trimIndent()
            val java = File(System.getProperty("java.home"), "bin/java").path
            val ending = ProcessBuilder(
                java,
                "-cp",
                System.getProperty("java.class.path"),
                "badlog.report.hook.RunHookKt",
                "${sample("qualification-42.bag")}",
                "python3",
                "-c",
                program,
            ).redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
            eventually("the hook to run") { report.readText().endsWith(".") }
            val (hook, child, header) = report.readText().split(' ')
            File(header).exists() shouldBe true
            ending.destroy()
            eventually("all to end") { !ending.isAlive && listOf(hook, child).none(::isRunning) }
            File(header).exists() shouldBe false
        } finally {
            report.delete()
        }
    }

    test("a hook that takes too long is killed, with its child processes").config(enabled = HAS_PYTHON) {
        val report = File.createTempFile("hook", ".txt")
        val program = """
            import os, subprocess, sys, time
            child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(3600)'])
            open(r'$report', 'w').write('%d %d .' % (os.getpid(), child.pid))
            time.sleep(3600)
        """.trimIndent()
        // Time passes once both run.
        val clock = { if (report.readText().endsWith(".")) 5.minutes.inWholeNanoseconds else 0L }
        shouldThrow<HookException> { python(program, nanos = clock) }.message shouldContain "took longer than 5m"
        val (hook, child) = report.readText().split(' ')
        eventually("both to end") { listOf(hook, child).none(::isRunning) }
        report.delete()
    }

    test("a process that outlives its hook and keeps its output open is killed at the time limit").config(enabled = HAS_PYTHON) {
        val program = """
            import subprocess, sys, time
            subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(300)'])
            print('{}')
        """.trimIndent()
        // Time stands still, so that only what outlives the hook can take too long.
        shouldThrow<HookException> { python(program, 1.seconds) }.message shouldContain "something it started took longer than 1s"
    }

    test("large output is read as fast as it comes").config(enabled = HAS_PYTHON) {
        val program = "import sys\nfor i in range(60): sys.stdout.write(' ' * 1000000)\nprint('{}')"
        python(program).values.keys.shouldBeEmpty()
    }

    test("too much output ends the hook").config(enabled = HAS_PYTHON) {
        val program = "import sys\nwhile True: sys.stdout.write('x' * 1000000)"
        shouldThrow<HookException> { python(program) }.message shouldContain "more than 64 MB"
    }

    test("a missing program is reported") {
        val failure = shouldThrow<HookException> { HookRunner(listOf("no-such-program-anywhere"), 1.seconds).run(RECORDING) }
        failure.message shouldStartWith "The program “no-such-program-anywhere” cannot be started ("
        failure.message shouldEndWith "); install it, or add its folder to the PATH."
    }
})
