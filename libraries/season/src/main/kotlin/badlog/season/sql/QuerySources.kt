package badlog.season.sql

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.contentOrNull

/**
 * What a query reads, as DuckDB's own parser sees it: for those who may read the tables of a lake and nothing else, such as files by
 * their names, DuckDB's settings, or its own tables, which show where the files of the lake are.
 */
internal class QuerySources private constructor(private val ownNames: Set<String>) {
    private fun check(element: JsonElement) {
        if (element is JsonArray) return element.forEach(::check)
        if (element !is JsonObject) return
        when (element.text("type")) {
            "BASE_TABLE" -> checkTable(element)
            "TABLE_FUNCTION" -> checkTableFunction(element)
            "SHOW_REF" -> element.text("table_name")?.takeIf { it.isNotEmpty() }?.let { checkName(it.removeSurrounding("\"")) }
        }
        if (element.text("class") == "FUNCTION") {
            val name = element.text("function_name").orEmpty().lowercase()
            if (name in SETTINGS) throw SqlException("The function $name is not available here.")
        }
        element.values.forEach(::check)
    }

    private fun checkTable(table: JsonObject) {
        if (listOf("schema_name", "catalog_name").any { !table.text(it).isNullOrEmpty() }) refuse(table.text("table_name").orEmpty())
        checkName(table.text("table_name").orEmpty())
    }

    private fun checkName(name: String) {
        if (name.lowercase() !in TABLES && name.lowercase() !in ownNames) refuse(name)
    }

    private fun checkTableFunction(function: JsonObject) {
        val name = (function["function"] as? JsonObject)?.text("function_name").orEmpty().lowercase()
        if (name !in FUNCTIONS) {
            throw SqlException("The table function $name is not available here; query the tables: ${TABLES.joinToString()}.")
        }
    }

    private fun refuse(name: String): Nothing = throw SqlException("There is no table “$name” here; there are ${TABLES.joinToString()}.")

    companion object {
        private val TABLES = LakeView.entries.map { it.sqlName }.toSet()

        /** Those that make rows of what a query gives them. */
        private val FUNCTIONS = setOf("unnest", "range", "generate_series", "json_each", "json_tree")
        private val SETTINGS = setOf("current_setting", "getenv", "getvariable")

        /** DuckDB has tables of its own whose names begin so; names of files have other characters in them. */
        private val OWN_NAME = Regex("(?!duckdb|pragma|sqlite|pg_)[a-z_][a-z0-9_]*")

        /**
         * Makes sure that the query [parsed], as DuckDB serializes it, reads nothing but the tables of a lake and what it calls a name of
         * its own.
         *
         * @throws SqlException when it does.
         */
        fun require(parsed: JsonElement) {
            val names = HashSet<String>()
            collectOwnNames(parsed, names)
            names.firstOrNull { !OWN_NAME.matches(it) }?.let {
                throw SqlException("“$it” cannot be the name of a common table expression here; use letters, digits and _.")
            }
            QuerySources(names).check(parsed)
        }

        private fun collectOwnNames(element: JsonElement, names: MutableSet<String>) {
            when (element) {
                is JsonArray -> element.forEach { collectOwnNames(it, names) }

                is JsonObject -> {
                    val map = (element["cte_map"] as? JsonObject)?.get("map") as? JsonArray
                    map?.mapNotNullTo(names) { (it as? JsonObject)?.text("key")?.lowercase() }
                    element.values.forEach { collectOwnNames(it, names) }
                }

                else -> Unit
            }
        }

        private fun JsonObject.text(name: String): String? = (this[name] as? JsonPrimitive)?.contentOrNull
    }
}
