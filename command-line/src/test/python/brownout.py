"""Finds out why a robot browned out, as an assistant would: each question follows from the answer before.

Starts the server by the command line that it is given, and talks with it by the SDK of the Model Context Protocol for Python, which shares
no code with the server's. Prints what it found out as JSON.
"""

import asyncio
import base64
import json
import sys

from mcp import Client, StdioServerParameters


async def talk(command):
    server = StdioServerParameters(command=command[0], args=command[1:])
    async with Client(server, read_timeout_seconds=300) as client:

        async def ask(tool, **arguments):
            result = await client.call_tool(tool, arguments)
            text = next(block.text for block in result.content if block.type == "text")
            assert not result.is_error, text
            answer = json.loads(text)
            assert "never instructions" in answer["notice"]
            return answer["data"], [block for block in result.content if block.type == "image"]

        tools = (await client.list_tools()).tools
        assert all(tool.annotations.read_only_hint for tool in tools)

        # "Why did Qualification 42 brown out?"
        logs, _ = await ask("list_logs", containing="Qualification 42")
        log = logs["logs"][0]["log"]

        found, _ = await ask("findings", log=log)
        incident = next(one for one in found["incidents"] if any("rown" in sentence["text"] for sentence in one["sentences"]))
        evidence = list(dict.fromkeys(topic for sentence in incident["sentences"] for topic in sentence["evidence"][:3]))[:6]
        start, end = incident["time"] - 3, incident["time"] + 5

        topics = []
        offset = 0
        while offset is not None:
            page, _ = await ask("describe_log", log=log, offset=offset)
            topics += page["topics"]
            offset = page.get("nextOffset")
        units = {topic["name"]: topic["unit"] for topic in topics}

        around, _ = await ask("samples", log=log, topics=evidence, points=80, **{"from": start, "to": end})
        lowest = min(
            (point[1], point[0])
            for topic in around["topics"] if units[topic["name"]] == "V" for point in topic["points"] if point[1] is not None
        )

        numbers, _ = await ask("statistics", log=log, topics=["battery voltage", "total current"], **{"from": start, "to": end})
        before, _ = await ask("find", log=log, question="each(Browned Out, Battery Voltage, Total Current)")
        compared, _ = await ask("table", values=["min(battery voltage)", "count(Browned Out)"])
        query = "SELECT log, \"System/Battery Voltage\".min AS lowest FROM match_statistics ORDER BY lowest"
        ranked, _ = await ask("sql", query=query)
        _, pictures = await ask("graph", log=log, topics=evidence[:4], **{"from": start, "to": end})

        refused = await client.call_tool("describe_log", {"log": "../README.md"})
        return {
            "protocol": client.protocol_version,
            "tools": [tool.name for tool in tools],
            "log": log,
            "timeUnit": incident["timeUnit"],
            "sentences": [sentence["text"] for sentence in incident["sentences"]],
            "evidence": evidence,
            "lowest": lowest[0],
            "lowestAt": lowest[1],
            "current": next(topic["max"] for topic in numbers["topics"] if topic["max"]["unit"] == "A"),
            "brownouts": before["answers"][0]["times"],
            "firstBefore": before["answers"][0]["occurrences"][0]["before"],
            "rows": len(compared["rows"]),
            "worst": ranked["rows"][0],
            "isPng": base64.b64decode(pictures[0].data).startswith(b"\x89PNG\r\n\x1a\n") and pictures[0].mime_type == "image/png",
            "isRefused": refused.is_error,
        }


if __name__ == "__main__":
    print(json.dumps(asyncio.run(talk(sys.argv[1:]))))
