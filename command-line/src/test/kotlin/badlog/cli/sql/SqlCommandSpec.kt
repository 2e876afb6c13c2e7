package badlog.cli.sql

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.Ended
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.cli.plugin.LakeCache
import badlog.cli.plugin.SeasonService
import badlog.cli.with
import badlog.core.waiting.eventually
import badlog.files.UserFolders
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.async
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.WRITE
import java.util.ServiceLoader
import kotlin.io.path.div
import kotlin.io.path.exists

class SqlCommandSpec : FunSpec({
    test("a query about a folder of logs is answered as a table, CSV and JSON") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val query = """SELECT number, header['Match Number'] AS match, max("Speed") AS fastest, 'a,b' AS "x""y" FROM samples JOIN matches USING (log, number) GROUP BY ALL"""
            badlog("sql", folder, query).out shouldBe "number  match  fastest  x\"y\n    42  42         5.5  a,b\n"
            badlog("sql", folder, query, "--csv").out shouldBe "number,match,fastest,\"x\"\"y\"\n42,42,5.5,\"a,b\"\n"
            badlog("sql", folder, query, "--json").out shouldBe """{"number":42,"match":"42","fastest":5.5,"x\"y":"a,b"}""" + "\n"
        }
    }

    test("later questions only read what changed") {
        inFolder { folder ->
            val logs = folder / "logs"
            logs.with("a.bag", BAG)
            badlog("sql", logs, "SELECT count(*) AS logs FROM matches", "--csv").out shouldBe "logs\n1\n"
            logs.with("b.bag", BAG)
            badlog("sql", logs, "SELECT count(*) AS logs FROM matches", "--csv").out shouldBe "logs\n2\n"
        }
    }

    test("a lake is queried without being remade, and an answer can be a Parquet file") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("lake", log, "--out", folder / "lake").code shouldBe ExitCode.WHOLE
            badlog("sql", folder / "lake", "SELECT title, rows FROM matches", "--parquet", folder / "answer.parquet").code shouldBe ExitCode.WHOLE
            (folder / "answer.parquet").exists() shouldBe true
            val secret = badlog("sql", folder / "lake", "SELECT * FROM read_text('$log')")
            secret.code shouldBe ExitCode.NOTHING
            secret.out shouldBe ""
        }
    }

    test("the tables are listed with their columns") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val ended = badlog("sql", folder, "--explain-tables")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "matches: a row per log"
            ended.out shouldContain "\"Speed\" double"
        }
    }

    test("without a query it reads queries from the standard input, and a mistake ends only its own") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val ended = asked(folder, "SELECT 1 AS one;\nSELECT nothing;\nSELECT\n 2 AS two;\nquit\nSELECT 3;")
            ended.out shouldBe "one\n  1\ntwo\n  2\n"
            ended.err shouldContain "nothing"
        }
    }

    test("a query waits while another badlog makes the tables of the same logs") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            badlog("sql", folder, "SELECT 1")
            val lake = LakeCache(UserFolders.ofSystem().answers, ServiceLoader.load(SeasonService::class.java).first().layoutVersion).lakeOf(folder)
            FileChannel.open(lake / ".lock", WRITE).use { channel ->
                val lock = channel.lock()
                val out = ByteArrayOutputStream()
                val err = ByteArrayOutputStream()
                val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(err, true, "UTF-8"), false)
                val code = async(Dispatchers.IO) { Badlog(console).run(listOf("sql", "$folder", "SELECT count(*) AS logs FROM matches", "--csv")) }
                eventually("the program to wait") { "Another badlog is making tables of the same logs; waiting" in err.toString(Charsets.UTF_8) }
                lock.release()
                code.await() shouldBe ExitCode.WHOLE
                out.toString(Charsets.UTF_8) shouldBe "logs\n1\n"
            }
        }
    }

    test("a wrong query is reported, and nothing is changed") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            badlog("sql", folder, "DROP TABLE matches").run {
                code shouldBe ExitCode.USAGE
                err shouldContain "Only a single query"
            }
            for (wrong in listOf("SELECT nothing FROM matches", "SELEC 1", "SELECT * FROM machtes", "SELECT 1/'a' FROM matches")) {
                badlog("sql", folder, wrong).code shouldBe ExitCode.USAGE
            }
            badlog("sql", folder, "SELECT 1", "--parquet", folder / "no" / "such" / "answer.parquet").code shouldBe ExitCode.NOTHING
            badlog("sql", folder / "nowhere", "SELECT 1").run {
                code shouldBe ExitCode.NOTHING
                err shouldContain "no file"
            }
            badlog("sql", folder, "SELECT 1", "--csv", "--json").code shouldBe ExitCode.USAGE
        }
    }
})

private fun asked(folder: Path, queries: String): Ended {
    val out = ByteArrayOutputStream()
    val err = ByteArrayOutputStream()
    val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(err, true, "UTF-8"), false)
    val code = Badlog(console, queries.byteInputStream()).run(listOf("sql", folder.toString()))
    return Ended(code, out.toString(Charsets.UTF_8), err.toString(Charsets.UTF_8))
}
