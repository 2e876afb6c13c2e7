package badlog.season.engine

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class EngineLibrarySpec : FunSpec({
    test("an error reports a system without a DuckDB library, and suggests an alternative") {
        shouldThrow<NoEngineException> { requireEngine("Windows 11", "aarch64") }.message shouldBe
            "DuckDB, which makes and reads lakes, has no library for Windows 11 on aarch64; use a Java for x64, which Windows on ARM can run."
    }

    test("all other systems with downloads have a DuckDB library") {
        for ((system, machine) in listOf("Windows 11" to "amd64", "Linux" to "amd64", "Linux" to "aarch64", "Mac OS X" to "aarch64", "Mac OS X" to "x86_64")) {
            requireEngine(system, machine)
        }
    }
})
