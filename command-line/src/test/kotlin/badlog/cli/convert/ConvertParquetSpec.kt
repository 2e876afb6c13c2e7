package badlog.cli.convert

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.Logged
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.sampleLog
import badlog.cli.with
import badlog.cli.wpilog
import badlog.core.python.TestPython
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readBytes

private val PYTHON = TestPython("pandas, pyarrow", "pandas and pyarrow")

@Tags("InCheck")
class ConvertParquetSpec : FunSpec({
    fun isParquet(file: Path) = file.readBytes().run { size > 8 && decodeToString(0, 4) == "PAR1" && decodeToString(size - 4, size) == "PAR1" }

    test("a log becomes a Parquet file beside it, and a folder one for each log") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("convert", log, "--to", "parquet")
            ended.out shouldBe "$log -> ${folder / "a.parquet"}\n  5 rows\n"
            ended.code shouldBe ExitCode.WHOLE
            isParquet(folder / "a.parquet") shouldBe true
            (folder / "logs").with("sub/b.bag.gz", BAG)
            (folder / "logs").with("c.bag", CUT_BAG)
            (folder / "logs").sampleLog("practice.bag")
            badlog("convert", folder / "logs", "--to", "parquet", "--out", folder / "out").code shouldBe ExitCode.SALVAGED
            (folder / "out").names() shouldContainExactly listOf("c.parquet", "practice.bag.parquet", "sub")
            isParquet(folder / "out/sub/b.parquet") shouldBe true
        }
    }

    test("NaN is a null in the file, and listed, with rows and with times of its own") {
        inFolder { folder ->
            val rows = folder.with("a.csv", "Time,x,y\n0,1,NaN\n1,NaN,2\n2,,-Infinity\n")
            badlog("convert", rows, "--to", "parquet").run {
                out shouldContain "  differs: NaN is written as null (2 in 2 topics)."
                code shouldBe ExitCode.WHOLE
            }
            badlogJson("convert", rows, "--to", "parquet", "--force").json.single().getValue("leftOut").jsonArray
                .map { it.jsonPrimitive.content } shouldContainExactly listOf("“x”: NaN is written as null.", "“y”: NaN is written as null.")
            val log = folder.wpilog("b.wpilog", listOf(Logged("v", "double", "", listOf(1.0 to 1.0, 2.0 to Double.NaN))))
            badlog("convert", log, "--to", "parquet").out shouldContain "  differs: NaN is written as null (1 in “v”)."
        }
    }

    test("the name after --out shows the format, and no file is replaced unasked") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("convert", log, "-o", folder / "b.parquet").code shouldBe ExitCode.WHOLE
            badlog("convert", log, "-o", folder / "b.parquet").run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "--force"
            }
            badlogJson("convert", log, "-o", folder / "b.parquet", "--force").out shouldBe
                """{"command":"convert","file":"$log","status":"whole","output":"${folder / "b.parquet"}","format":"parquet","rows":5,"leftOut":[],"undefined":[]}""" + "\n"
            folder.names() shouldContainExactly listOf("a.bag", "b.parquet")
        }
    }

    test("options that make rows or compress have no effect on it, and are refused") {
        for (option in listOf("--gzip", "--x=Time", "--period=0.1", "--rows-at=Time", "--changes-only")) {
            val ended = badlog("convert", SAMPLES / "practice.bag", "--to", "parquet", option)
            ended.code shouldBe ExitCode.USAGE
            ended.err shouldStartWith "${option.substringBefore('=')} has no effect"
        }
    }

    test("pandas reads the selected and the added topics").config(enabledOrReasonIf = PYTHON.isHere) {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val target = folder / "a.parquet"
            badlog("convert", log, "-o", target, "--only", "Speed", "--only", "Twice", "--topic", "Twice [m/s] = 2 * Speed").code shouldBe ExitCode.WHOLE
            val script = folder.with("read.py", "import pandas, sys\nrows = pandas.read_parquet(sys.argv[1])\nprint(rows.to_csv(index=False), end='')\n")
            val python = PYTHON.running("$script", "$target")
            python.inputReader().readText() shouldBe """
                log,type,number,t,Speed,Twice
                a.bag,,42,0.0,1.5,3.0
                a.bag,,42,0.02,2.5,5.0
                a.bag,,42,0.04,3.5,7.0
                a.bag,,42,0.06,,
                a.bag,,42,0.08,5.5,11.0

            """.trimIndent()
            python.waitFor() shouldBe 0
        }
    }
})
