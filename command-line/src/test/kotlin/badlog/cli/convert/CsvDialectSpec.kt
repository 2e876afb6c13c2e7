package badlog.cli.convert

import badlog.cli.ROOT
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.core.python.TestPython
import badlog.files.inFolder
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlin.io.path.createDirectory
import kotlin.io.path.div
import kotlin.random.Random

private val PYTHON = TestPython("pandas, pyarrow", "pandas and pyarrow")

@Tags("InCheck")
class CsvDialectSpec : FunSpec({
    fun said(vararg arguments: Any): String {
        val process = PYTHON.running((ROOT / "command-line/src/test/python/csv_dialects.py").toString(), *arguments.map { "$it" }.toTypedArray())
        return process.inputStream.readAllBytes().decodeToString().also { process.waitFor() shouldBe 0 }
    }

    test("badlog, which finds the dialect of a CSV file, reads the values that pandas reads, which is told it").config(enabledOrReasonIf = PYTHON.isHere) {
        val seed = Random.nextInt(1_000_000)
        inFolder { folder ->
            val files = (folder / "in").createDirectory()
            said("write", files, seed, FILES)
            withClue("seed $seed") {
                badlog("convert", files, "--to", "parquet", "--out", folder / "out").code shouldBe ExitCode.WHOLE
                said("compare", files, folder / "out").trim().toInt() shouldBeGreaterThan FILES * MIN_VALUES
            }
        }
    }
})

private const val FILES = 60

/** The fewest values of a file: five rows of two columns. */
private const val MIN_VALUES = 10
