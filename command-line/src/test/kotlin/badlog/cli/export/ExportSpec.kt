package badlog.cli.export

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.ExitCode
import badlog.cli.badlog
import badlog.cli.inFolder
import badlog.cli.names
import badlog.cli.with
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.div
import kotlin.io.path.readText

class ExportSpec : FunSpec({
    test("a page stands beside its log, or below the folder for all") {
        inFolder { folder ->
            folder.with("logs/a.bag", BAG)
            folder.with("logs/deep/b.bag", CUT_BAG)
            badlog("export", folder / "logs/a.bag").code shouldBe ExitCode.WHOLE
            (folder / "logs/a.bag.html").readText().take(15) shouldBe "<!DOCTYPE html>"
            val ended = badlog("export", folder / "logs", "-o", folder / "pages")
            ended.code shouldBe ExitCode.SALVAGED
            ended.out shouldContain "error    line 7"
            (folder / "pages").names() shouldContainExactly listOf("a.bag.html", "deep")
        }
    }

    test("attachments are in the page, and a missing one stops before any work") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val notes = folder.with("notes.txt", "hello")
            badlog("export", log, "-a", notes).code shouldBe ExitCode.WHOLE
            (folder / "a.bag.html").readText() shouldContain "notes.txt"
            badlog("export", log, "-a", folder / "nix.txt", "--force").code shouldBe ExitCode.NOTHING
        }
    }
})
