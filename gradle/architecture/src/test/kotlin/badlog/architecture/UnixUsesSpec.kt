package badlog.architecture

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import java.io.File

/** Tests that uses of Unix are guarded, so that `check` passes on Windows. A test without its requirements is skipped with a reason. */
class UnixUsesSpec : FunSpec({
    test("tests and builds guard their uses of Unix") {
        val tests = sourcesUnder(ROOT).filter { it.isTest || it.path.startsWith("benchmarks/") }.map { it.path }
        val builds = ROOT.walk().onEnter { it == ROOT || (it.name !in SKIPPED_FOLDERS && !it.name.startsWith('.')) }
            .filter { it.extension == "gradle" }.map { it.relativeTo(ROOT).invariantSeparatorsPath }
        (tests + builds).filterNot { it.endsWith("UnixUsesSpec.kt") }
            .flatMap { path -> unguarded(File(ROOT, path).readText()).map { "$path: $it" } }.shouldBeEmpty()
    }

    test("a use in a test needs a guard of that test, and one elsewhere a guard in the file") {
        val link = "Files.createSymbolicLink(a, b)"
        unguarded("    test(\"a\") {\n        $link\n    }\n") shouldContainExactly listOf(link)
        unguarded("    test(\"a\").config(enabledOrReasonIf = { IF_LINKS }) {\n        $link\n    }\n    test(\"b\") {\n    }\n").shouldBeEmpty()
        unguarded("    test(\"a\").config(enabledOrReasonIf = { IF_LINKS }) {\n    }\n    test(\"b\") {\n        $link\n    }\n") shouldContainExactly listOf(link)
        unguarded("commandLine 'sh', '-c', 'true'\n") shouldContainExactly listOf("commandLine 'sh', '-c', 'true'")
        unguarded("def isThere = File.separatorChar == '/'\ncommandLine 'sh', '-c', 'true'\n").shouldBeEmpty()
        unguarded("BadLog.init(\"/dev/null\")") shouldContainExactly listOf("BadLog.init(\"/dev/null\")")
    }
})

private val ROOT = File("../..").canonicalFile
private val SKIPPED_FOLDERS = setOf("build", "node_modules")

/** Permissions, devices, programs and signals of Unix, and links, which on Windows need an administrator. */
private val USE = Regex(
    """setPosixFilePermissions|/dev/(?:full|null)|["']sh["']|#!/bin/sh|["']unshare["']|["']kill["']|createSymbolicLink|["']mkfifo["']|["']chmod["']""",
)

/** Checks of the operating system or of a program's presence. */
private val GUARD = Regex("""separatorChar|os\.name|isWindows|canExecute|isExecutable|isInstalled|canRun|IF_LINUX|IF_POSSIBLE|supportedFileAttributeViews|/usr/bin/mkfifo""")

/** The beginning of a test, up to its body. */
private val TEST = Regex("""(?m)^ *(?:test|browserTest)\((?:[^{]|\{ [^{}]*\})*\{$""")

/** Returns the lines of [code] that use features of Unix without a guard. */
private fun unguarded(code: String): List<String> {
    val heads = TEST.findAll(code).toList()
    return USE.findAll(code).mapNotNull { use ->
        val head = heads.lastOrNull { it.range.last < use.range.first }
        val ends = head != null && Regex("(?m)^" + head.value.takeWhile { it == ' ' } + """\}""").find(code, head.range.last)?.let { it.range.first < use.range.first } == true
        val isGuarded = if (head == null || ends) GUARD.containsMatchIn(code) else "enabled" in head.value
        if (isGuarded) null else code.substring(code.lastIndexOf('\n', use.range.first) + 1).substringBefore('\n').trim()
    }.toList()
}
