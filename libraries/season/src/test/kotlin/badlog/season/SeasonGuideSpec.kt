package badlog.season

import badlog.core.python.TestPython
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.maps.shouldHaveSize
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.double
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.absolute
import kotlin.io.path.div
import kotlin.io.path.exists

private val PYTHON = TestPython("pandas, pyarrow, polars, duckdb", "pandas, pyarrow, Polars and DuckDB")

@Tags("InCheck")
class SeasonGuideSpec : FunSpec({
    test("each Python example of the guide runs on a lake of the samples, with the same results as SQL").config(enabledOrReasonIf = PYTHON.isHere) {
        inFolder { folder ->
            refresh(Path.of("../../samples"), folder / "season")
            // Logs of unknown events and logs without the topic are typical causes of failing examples.
            (folder / "season/samples/season=__HIVE_DEFAULT_PARTITION__").exists() shouldBe true
            val sql = "SELECT log, min(\"System/Battery Voltage\") AS low FROM samples GROUP BY log HAVING low IS NOT NULL"
            val expected = rowsOf(folder / "season", sql).associate { (log, low) -> log.jsonPrimitive.content to low.jsonPrimitive.double }
            expected.entries.shouldNotBeEmpty()
            val script = Path.of("src/test/python/run_guide.py").absolute()
            val guide = Path.of("../../docs/season.md").absolute()
            val python = ProcessBuilder(PYTHON.command, "$script", "$guide").directory(folder.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start()
            val output = python.inputStream.readAllBytes().decodeToString()
            python.waitFor() shouldBe 0
            val found = Json.parseToJsonElement(output).jsonObject.mapValues { (_, lows) -> lows.jsonObject.mapValues { it.value.jsonPrimitive.double } }
            found shouldHaveSize 4
            for ((_, lows) in found) lows shouldBe expected
        }
    }
})
