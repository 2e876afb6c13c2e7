package badlog.cli.plugin

import badlog.cli.names
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import kotlin.io.path.div

class LakeCacheSpec : FunSpec({
    test("lakes of former layouts are removed, and nothing else") {
        inFolder { folder ->
            for (name in listOf("answers/a", "lakes/logs-1/lake.json", "lakes-v1/logs-1/lake.json", "lakes-v2/x", "lakes-v3/x", "lakes-vital/x")) folder.with(name, "")
            LakeCache(folder / "answers", layoutVersion = 2).lakeOf(folder).parent shouldBe folder / "lakes-v2"
            folder.names() shouldContainExactly listOf("answers", "lakes-v2", "lakes-v3", "lakes-vital")
        }
    }

    test("each folder of logs has a lake of its own, and each user of it") {
        inFolder { folder ->
            folder.with("a/logs/x.bag", "")
            folder.with("b/logs/x.bag", "")
            val cache = LakeCache(folder / "answers", layoutVersion = 1)
            cache.lakeOf(folder / "a/logs") shouldBe cache.lakeOf(folder / "a/../a/logs")
            cache.lakeOf(folder / "a/logs") shouldNotBe cache.lakeOf(folder / "b/logs")
            cache.lakeOf(folder / "a/logs") shouldNotBe cache.lakeOf(folder / "a/logs", "mcp")
        }
    }
})
