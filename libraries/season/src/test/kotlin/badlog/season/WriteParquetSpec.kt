package badlog.season

import badlog.files.inFolder
import badlog.season.engine.Engine
import badlog.season.engine.NumberColumn
import badlog.season.engine.Table
import badlog.season.lake.writeParquet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.io.path.div

class WriteParquetSpec : FunSpec({
    test("a table that is larger than DuckDB's memory is written, a group of rows at a time") {
        inFolder { folder ->
            val numbers = DoubleArray(40_000) { it % 1_000 / 7.0 }
            val table = Table(List(400) { NumberColumn("topic $it", numbers) }, numbers.size)
            Engine(memoryMegabytes = 100, threads = 1).use { engine ->
                val rows = engine.connected { connection ->
                    engine.lend(table) { select -> writeParquet(connection, select, folder / "wide.parquet", columns = table.columns.size) }
                }
                rows shouldBe 40_000
            }
        }
    }
})
