package badlog.season

import badlog.core.python.TestPython
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlin.io.path.div

private val PYTHON = TestPython("pandas, pyarrow, polars", "pandas, pyarrow and Polars")

@Tags("InCheck")
class PythonReadersSpec : FunSpec({
    test("pandas, pyarrow and Polars read a lake without badlog").config(enabledOrReasonIf = PYTHON.isHere) {
        inFolder { folder ->
            (folder / "logs").put("q1.bag", matchBag(1, 12.5, 11.5))
            (folder / "logs").put("q2.bag", matchBag(2, 12.5, 6.5, event = "Lake/Side"))
            refresh(folder / "logs", folder / "lake")
            val python = PYTHON.running("src/test/python/read_lake.py", "${folder / "lake"}")
            val output = python.inputStream.readAllBytes().decodeToString()
            python.waitFor() shouldBe 0
            Json.parseToJsonElement(output) shouldBe Json.parseToJsonElement(
                """
                {
                  "pandas": ["Lake/Side Qualification 2 2025 2025-03-14T10:00:00+00:00", "Mill Creek Qualification 1 2025 2025-03-14T10:00:00+00:00"],
                  "pyarrow": {"1": 11.5, "2": 6.5},
                  "polars": [["Mill Creek", 1, 11.5], ["Lake/Side", 2, 6.5]],
                  "unit": "V",
                  "attributes": ["zero"]
                }
                """,
            )
        }
    }
})
