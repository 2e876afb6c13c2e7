package badlog.cli.convert

import badlog.cli.ROOT
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.core.python.TestPython
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlin.io.path.createDirectory
import kotlin.io.path.div

private val PYTHON = TestPython("pandas, pyarrow", "pandas and pyarrow")

@Tags("InCheck")
class CsvDialectSpec : FunSpec({
    fun said(vararg arguments: Any): String {
        val process = PYTHON.running((ROOT / "command-line/src/test/python/csv_dialects.py").toString(), *arguments.map { "$it" }.toTypedArray())
        return process.inputStream.readAllBytes().decodeToString().also { process.waitFor() shouldBe 0 }
    }

    test("badlog finds the dialect of a CSV file, and reads the same values as pandas with that dialect").config(enabledOrReasonIf = PYTHON.isHere) {
        inFolder { folder ->
            val files = (folder / "in").createDirectory()
            said("write", files, SEED, FILES)
            badlog("convert", files, "--to", "parquet", "--out", folder / "out").code shouldBe ExitCode.WHOLE
            said("compare", files, folder / "out").trim().toInt() shouldBeGreaterThan FILES * MIN_VALUES
        }
    }
})

private const val FILES = 60

/** The same files in each run, so that a failure comes from the latest change. */
private const val SEED = 2026

/** The fewest values of a file: five rows of two columns. */
private const val MIN_VALUES = 10
