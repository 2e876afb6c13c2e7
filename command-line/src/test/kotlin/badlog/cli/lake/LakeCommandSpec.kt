package badlog.cli.lake

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.exists

class LakeCommandSpec : FunSpec({
    test("a folder becomes a lake, and a second run says that nothing changed, and reports the same damage") {
        inFolder { folder ->
            (folder / "logs").with("a.bag", BAG)
            (folder / "logs").with("b/cut.bag", CUT_BAG)
            val first = badlog("lake", folder / "logs", "--out", folder / "lake")
            first.out shouldBe "${folder / "lake"}: 2 logs written (1 with data missing)\n"
            first.code shouldBe ExitCode.SALVAGED
            (folder / "lake/lake.json").exists() shouldBe true
            val second = badlog("lake", folder / "logs", "--out", folder / "lake")
            second.out shouldBe "${folder / "lake"}: 0 logs written, 2 unchanged (1 with data missing)\n"
            second.code shouldBe ExitCode.SALVAGED
            second.err shouldBe first.err
        }
    }

    test("programs get a line for each log") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlogJson("lake", log, "--out", folder / "lake").out shouldBe
                """{"command":"lake","file":"$log","status":"whole","written":true}""" + "\n"
        }
    }

    test("a folder that holds something else is not written to") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            (folder / "mine").with("thesis.txt", "mine")
            val ended = badlog("lake", log, "--out", folder / "mine")
            ended.code shouldBe ExitCode.NOTHING
            ended.err shouldContain "has other files in it"
        }
    }

    test("without --out, lake reports the missing folder") {
        badlog("lake", "a").code shouldBe ExitCode.USAGE
    }
})
